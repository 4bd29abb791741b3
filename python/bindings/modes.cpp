#include <fourpost/modes.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"

namespace fourpost::python {
namespace {

/// Bodies, and their six components each: along x, y, z and about them.
py::tuple ShapeOf(const api::Mode& mode) {
  std::vector<std::string> bodies;
  Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 6, Eigen::RowMajor> components(mode.shape.size(), 6);
  for (std::size_t i = 0; i < mode.shape.size(); ++i) {
    bodies.push_back(mode.shape[i].body);
    components.row(static_cast<Eigen::Index>(i)) << mode.shape[i].translation.transpose(),
        mode.shape[i].rotation.transpose();
  }
  return py::make_tuple(bodies, components);
}

py::tuple FindModes(const api::Vehicle& vehicle) {
  const api::Modes found = Computed([&](const Stop&) { return api::FindModes(vehicle); });
  py::list modes;
  for (const api::Mode& one : found.modes)
    modes.append(py::make_tuple(one.name, one.kind, one.frequency_Hz, one.damped_frequency_Hz, one.damping_ratio,
                                one.rise_time_s, one.settling_time_s, one.poles, one.kinetic_energy, ShapeOf(one)));
  const api::StateSpace& space = found.state_space;
  return py::make_tuple(modes,
                        py::make_tuple(space.posts, space.sensors, space.a, space.b, space.c, space.d, space.d_rate,
                                       space.d_acceleration),
                        FindingsOf(found.warnings));
}

py::list FollowPoles(const api::Vehicle& vehicle, const std::string& parameter, const std::vector<double>& values) {
  const std::vector<api::PolePath> paths =
      Computed([&](const Stop&) { return api::FollowPoles(vehicle, parameter, values); });
  py::list list;
  for (const api::PolePath& path : paths) list.append(py::make_tuple(path.mode, path.poles));
  return list;
}

}  // namespace

void BindModes(py::module_& module) {
  module.def("find_modes", &FindModes);
  module.def("follow_poles", &FollowPoles);
}

}  // namespace fourpost::python
