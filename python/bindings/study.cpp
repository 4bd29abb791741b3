#include <fourpost/objective.h>
#include <fourpost/study.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"
#include "python/bindings/parameters.h"

namespace fourpost::python {
namespace {

using Columns = std::map<std::string, Eigen::VectorXd>;
/// Response, relative standard deviation at each frequency, mean and its standard deviation.
using Measured = std::tuple<Eigen::VectorXcd, Eigen::VectorXd, Eigen::VectorXd, Eigen::VectorXd>;

void AddSine(api::Study& study, const std::string& name, const std::string& posts,
             const std::vector<double>& frequency_Hz, const std::vector<double>& amplitude_m,
             const std::map<std::string, Measured>& channels, bool is_validation) {
  api::SteppedSineTest test{.name = name,
                            .posts = posts,
                            .frequency_Hz = frequency_Hz,
                            .amplitude_m = amplitude_m,
                            .channels = {},
                            .is_validation = is_validation};
  for (const auto& [sensor, measured] : channels)
    test.channels[sensor] = {.frf = std::get<0>(measured),
                             .mean = std::get<2>(measured),
                             .relative_sd_at = std::get<1>(measured),
                             .mean_sd = std::get<3>(measured)};
  study.Add(std::move(test));
}

void AddHistory(api::Study& study, const std::string& name, double rate_Hz, const Columns& posts,
                const Columns& channels, const std::map<std::string, double>& noise,
                const std::optional<std::pair<int, double>>& filter, bool is_validation) {
  api::TimeHistoryTest test{.name = name,
                            .rate_Hz = rate_Hz,
                            .posts = posts,
                            .channels = channels,
                            .noise = noise,
                            .is_validation = is_validation};
  if (filter) test.filter = api::LowPass{filter->first, filter->second};
  study.Add(std::move(test));
}

void AddBench(api::Study& study, double rate_Hz, const Eigen::VectorXd& displacement, const Eigen::VectorXd& force,
              bool is_validation) {
  study.Add(api::BenchTest{rate_Hz, displacement, force, is_validation});
}

void SetLoads(api::Study& study, const std::map<std::string, std::pair<double, double>>& loads) {
  for (const auto& [tyre, load] : loads) study.static_loads[tyre] = {load.first, load.second};
}

void SetModelError(api::Study& study, double gain_dB, double phase_deg, double floor, double history, double bench,
                   double mean_m) {
  study.model_error = {gain_dB, phase_deg, floor, history, bench, mean_m};
}

void BindObjective(py::module_& module) {
  py::class_<api::Objective>(module, "Objective")
      .def(py::init(
          [](const api::Study& study) { return Computed([&](const Stop&) { return api::Objective(study); }); }))
      .def_property_readonly("parameters",
                             [](const api::Objective& objective) { return ParametersOf(objective.parameters()); })
      .def_property_readonly("count", &api::Objective::residual_count)
      .def("residuals", &api::Objective::Residuals, py::call_guard<py::gil_scoped_release>())
      .def("jacobian",
           [](const api::Objective& objective, const Eigen::VectorXd& values) {
             return Computed([&](const Stop& stop) { return objective.Jacobian(values, stop); });
           })
      .def("residuals_at",
           [](const api::Objective& objective, const Eigen::MatrixXd& values, int threads) {
             return Computed([&](const Stop& stop) { return objective.ResidualsAt(values, threads, stop); });
           })
      .def("costs_at", [](const api::Objective& objective, const Eigen::MatrixXd& values, int threads) {
        return Computed([&](const Stop& stop) { return objective.CostsAt(values, threads, stop); });
      });
}

}  // namespace

void BindStudy(py::module_& module) {
  py::class_<api::Study>(module, "Study")
      .def(py::init<api::Vehicle>())
      .def(py::init<std::filesystem::path>())
      .def("add_sine", &AddSine)
      .def("add_history", &AddHistory)
      .def("add_bench", &AddBench)
      .def("set_loads", &SetLoads)
      .def("set_model_error", &SetModelError)
      .def_readwrite("free", &api::Study::free)
      .def_readwrite("band_Hz", &api::Study::band_Hz)
      .def_readwrite("seed", &api::Study::seed)
      .def_readwrite("evaluations", &api::Study::evaluations)
      .def_readwrite("starts", &api::Study::starts)
      .def("write", &api::Study::Write);
  BindObjective(module);
}

}  // namespace fourpost::python
