#include <fourpost/units.h>
#include <fourpost/vehicle.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"
#include "python/bindings/parameters.h"

namespace fourpost::python {
namespace {

py::dict SensorsOf(const api::Vehicle& vehicle) {
  py::dict units;
  for (const api::Sensor& sensor : vehicle.sensors()) units[py::str(sensor.name)] = sensor.unit;
  return units;
}

}  // namespace

py::list ParametersOf(const std::vector<api::Parameter>& parameters) {
  py::list rows;
  for (const api::Parameter& one : parameters)
    rows.append(py::make_tuple(one.name, one.value, one.lower, one.upper, api::SiUnitOf(one.unit)));
  return rows;
}

void BindVehicle(py::module_& module) {
  py::class_<api::Vehicle>(module, "Vehicle")
      .def_property_readonly("name", &api::Vehicle::name)
      .def_property_readonly("links", &api::Vehicle::links)
      .def_property_readonly("posts", &api::Vehicle::posts)
      .def_property_readonly("sensors", &SensorsOf)
      .def_property_readonly("parameters",
                             [](const api::Vehicle& vehicle) { return ParametersOf(vehicle.parameters()); })
      .def("value", &api::Vehicle::Value)
      .def("set", py::overload_cast<const std::string&, const std::string&>(&api::Vehicle::Set))
      .def("set", py::overload_cast<const std::string&, double>(&api::Vehicle::Set))
      .def("copy", [](const api::Vehicle& vehicle) { return api::Vehicle(vehicle); })
      .def("text", &api::Vehicle::Text);
  module.def("read_vehicle", [](const std::filesystem::path& file) {
    std::vector<api::Finding> warnings;
    const api::Vehicle vehicle = Computed([&](const Stop&) { return api::ReadVehicle(file, &warnings); });
    return py::make_tuple(vehicle, FindingsOf(warnings));
  });
  module.def("check_vehicle", [](const api::Vehicle& vehicle) {
    return FindingsOf(Computed([&](const Stop&) { return api::CheckVehicle(vehicle); }));
  });
}

}  // namespace fourpost::python
