#include <fourpost/fit.h>
#include <fourpost/run.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"

namespace fourpost::python {
namespace {

/// Termination, whether the data are explained, cost, number of residuals, parameters, warnings.
py::tuple ReadResult(const std::filesystem::path& folder) {
  const api::Result result = api::ReadResult(folder);
  py::list parameters;
  for (const api::FittedParameter& one : result.parameters)
    parameters.append(py::make_tuple(one.name, one.value, one.sd, one.lower_95, one.upper_95, one.start, one.unit,
                                     one.state, one.is_at_bound));
  return py::make_tuple(result.termination, result.explains_data, result.cost, result.residuals, parameters,
                        FindingsOf(result.warnings));
}

py::tuple Draw(const std::filesystem::path& run, int count, std::uint64_t seed,
               const std::filesystem::path& noise_of_study, int threads) {
  const api::Draws draws = Computed([&](const Stop& stop) {
    return api::Draw(
        run, {.count = count, .seed = seed, .noise_of_study = noise_of_study, .threads = threads, .stop = stop});
  });
  return py::make_tuple(draws.parameters, draws.units, draws.values, draws.held, FindingsOf(draws.warnings));
}

py::tuple Predict(const std::filesystem::path& run, const std::filesystem::path& recording, const std::string& engine,
                  const std::string& posts, const std::string& release, std::optional<double> start_s,
                  const std::filesystem::path& output) {
  const api::Engine by = EngineOf(engine);
  const api::Prediction prediction = Computed([&](const Stop& stop) {
    return api::Predict(
        run, recording,
        {.engine = by, .posts = posts, .release = release, .start_s = start_s, .output = output, .stop = stop});
  });
  return py::make_tuple(prediction.json, FindingsOf(prediction.warnings));
}

py::tuple Choose(const std::filesystem::path& run, const std::filesystem::path& settings, int threads,
                 const std::filesystem::path& output) {
  const api::Choice choice = Computed([&](const Stop& stop) {
    return api::Choose(run, settings, {.threads = threads, .output = output, .stop = stop});
  });
  return py::make_tuple(choice.json, FindingsOf(choice.warnings));
}

}  // namespace

void BindRun(py::module_& module) {
  module.def("read_result", &ReadResult);
  module.def("draw", &Draw);
  module.def("predict", &Predict);
  module.def("choose", &Choose);
}

}  // namespace fourpost::python
