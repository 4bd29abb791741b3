#include <fourpost/simulate.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"

namespace fourpost::python {
namespace {

py::tuple Simulate(const api::Vehicle& vehicle, double rate_Hz, const std::map<std::string, Eigen::VectorXd>& height_m,
                   double stroke_m, const std::string& engine) {
  const api::PostHeights posts{rate_Hz, height_m, stroke_m};
  const api::Engine by = EngineOf(engine);
  const api::History history = Computed([&](const Stop& stop) { return api::Simulate(vehicle, posts, by, stop); });
  return py::make_tuple(history.readings, NameOf(history.engine), history.step_change, history.kinematics_error);
}

}  // namespace

void BindSimulate(py::module_& module) { module.def("simulate", &Simulate); }

}  // namespace fourpost::python
