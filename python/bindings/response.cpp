#include <complex>
#include <map>

#include <fourpost/response.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"

namespace fourpost::python {
namespace {

using Complex = std::complex<double>;

const std::map<std::string, api::Engine>& Engines() {
  static const std::map<std::string, api::Engine> engines = {{"auto", api::Engine::kAuto},
                                                             {"reduced", api::Engine::kReduced},
                                                             {"full", api::Engine::kFull},
                                                             {"time_integration", api::Engine::kTimeIntegration}};
  return engines;
}

py::object NumberOrNone(const std::optional<double>& number) { return number ? py::cast(*number) : py::none(); }

/// Responses as arrays, rows x sensors x frequencies; NaN in a row without any.
struct Arrays {
  Arrays(std::size_t rows, std::size_t sensors, std::size_t frequencies)
      : frf(std::vector{rows, sensors, frequencies}),
        mean(std::vector{rows, sensors, frequencies}),
        second_harmonic(std::vector{rows, sensors, frequencies}) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::fill_n(frf.mutable_data(), frf.size(), Complex(kNone, kNone));
    std::fill_n(mean.mutable_data(), mean.size(), kNone);
    std::fill_n(second_harmonic.mutable_data(), second_harmonic.size(), kNone);
  }

  void Put(std::size_t row, const api::Response& response) {
    for (std::size_t c = 0; c < response.channels.size(); ++c) {
      const api::ChannelResponse& channel = response.channels[c];
      std::copy(channel.frf.begin(), channel.frf.end(), frf.mutable_data(row, c));
      std::copy(channel.mean.begin(), channel.mean.end(), mean.mutable_data(row, c));
      std::copy(channel.second_harmonic.begin(), channel.second_harmonic.end(), second_harmonic.mutable_data(row, c));
    }
  }

  py::array_t<Complex> frf;
  py::array_t<double> mean;
  py::array_t<double> second_harmonic;
};

py::tuple UsualSine(const api::Vehicle& vehicle, const std::string& posts, const std::vector<double>& frequency_Hz) {
  const api::SteppedSine sine = api::UsualSine(vehicle, posts, frequency_Hz);
  return py::make_tuple(sine.frequency_Hz, sine.amplitude_m);
}

py::tuple Respond(const api::Vehicle& vehicle, const std::vector<double>& frequency_Hz,
                  const std::vector<double>& amplitude_m, const std::string& posts, double stroke_m,
                  const std::string& engine) {
  const api::SteppedSine sine{frequency_Hz, amplitude_m, posts, stroke_m};
  const api::Engine by = EngineOf(engine);
  const api::Response response = Computed([&](const Stop& stop) { return api::Respond(vehicle, sine, by, stop); });
  Arrays arrays(1, response.channels.size(), frequency_Hz.size());
  arrays.Put(0, response);
  return py::make_tuple(arrays.frf, arrays.mean, arrays.second_harmonic, NameOf(response.engine),
                        NumberOrNone(response.kinematics_error_dB), NumberOrNone(response.kinematics_error_deg));
}

py::tuple RespondAt(const api::Vehicle& vehicle, const std::vector<std::string>& parameters,
                    const Eigen::MatrixXd& values, const std::vector<double>& frequency_Hz,
                    const std::vector<double>& amplitude_m, const std::string& posts, double stroke_m,
                    const std::string& engine, int threads) {
  const api::SteppedSine sine{frequency_Hz, amplitude_m, posts, stroke_m};
  const api::ParameterTable table{parameters, values};
  const api::Engine by = EngineOf(engine);
  const std::vector<api::RowResponse> rows = Computed([&](const Stop& stop) {
    return api::RespondAt(vehicle, table, sine, {.engine = by, .threads = threads, .stop = stop});
  });
  Arrays arrays(rows.size(), vehicle.sensors().size(), frequency_Hz.size());
  py::list engines;
  py::dict failures;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].response) arrays.Put(i, *rows[i].response);
    else failures[py::int_(i)] = rows[i].why;
    engines.append(rows[i].response ? py::object(py::str(NameOf(rows[i].response->engine))) : py::none());
  }
  return py::make_tuple(arrays.frf, arrays.mean, arrays.second_harmonic, engines, failures);
}

}  // namespace

api::Engine EngineOf(const std::string& name) {
  std::string known;
  for (const auto& [one, engine] : Engines()) {
    if (one == name) return engine;
    known += (known.empty() ? "" : ", ") + one;
  }
  const std::string text = "there is no engine '" + name + "'; give one of: " + known;
  throw api::Error(api::Error::Kind::kInput, text, {{.code = "name-unknown", .is_error = true, .text = text}});
}

std::string NameOf(api::Engine engine) {
  for (const auto& [name, one] : Engines())
    if (one == engine) return name;
  return "auto";
}

void BindResponse(py::module_& module) {
  module.def("usual_sine", &UsualSine);
  module.def("respond", &Respond);
  module.def("respond_at", &RespondAt);
}

}  // namespace fourpost::python
