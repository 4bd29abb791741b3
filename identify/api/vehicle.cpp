#include <filesystem>

#include <fourpost/units.h>
#include <fourpost/vehicle.h>

#include "identify/api/errors.h"
#include "identify/api/inside.h"
#include "vehicles/lint/vehicle_lint.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost::api {
namespace {

template <typename Elements>
std::vector<std::string> NamesOf(const Elements& elements) {
  std::vector<std::string> names;
  for (const auto& element : elements) names.push_back(element.name);
  return names;
}

const fourpost::Parameter& ParameterOf(const fourpost::Vehicle& vehicle, const std::string& name) {
  for (const fourpost::Parameter& parameter : vehicle.parameters)
    if (parameter.name == name) return parameter;
  RefuseName("parameter", name, NamesOf(vehicle.parameters));
}

}  // namespace

Vehicle::Vehicle(std::shared_ptr<const fourpost::Vehicle> description) : description_(std::move(description)) {}

const std::string& Vehicle::name() const { return description_->name; }
std::vector<std::string> Vehicle::links() const { return NamesOf(description_->links); }
std::vector<std::string> Vehicle::posts() const { return NamesOf(description_->posts); }

std::vector<Sensor> Vehicle::sensors() const {
  std::vector<Sensor> sensors;
  for (const fourpost::Sensor& sensor : description_->sensors) sensors.push_back({sensor.name, UnitOf(sensor.type)});
  return sensors;
}

std::vector<Parameter> Vehicle::parameters() const {
  std::vector<Parameter> parameters;
  for (const fourpost::Parameter& one : description_->parameters)
    parameters.push_back({one.name, one.value, one.lower, one.upper, one.unit});
  return parameters;
}

double Vehicle::Value(const std::string& parameter) const { return ParameterOf(*description_, parameter).value; }

void Vehicle::Set(const std::string& parameter, const std::string& quantity) {
  ParameterOf(*description_, parameter);
  auto changed = std::make_shared<fourpost::Vehicle>(*description_);
  Guarded([&] {
    Diagnostics found;
    SetParameter(parameter + "=" + quantity, "Set", *changed, found);
    if (found.HasErrors()) throw FaultyInput(found);
  });
  description_ = std::move(changed);
}

void Vehicle::Set(const std::string& parameter, double value) {
  Guarded([&] { RequireFinite("'" + parameter + "'", {&value, 1}); });
  Set(parameter, InUnit(value, ParameterOf(*description_, parameter).unit));
}

std::string Vehicle::Text() const {
  return VehicleTextWithValues(*description_, description_->ParameterValues(),
                               std::filesystem::path(description_->file).parent_path());
}

Vehicle ReadVehicle(const std::filesystem::path& file, std::vector<Finding>* warnings) {
  return Guarded([&] {
    Diagnostics found;
    std::optional<fourpost::Vehicle> vehicle = fourpost::ReadVehicle(file, found);
    if (!vehicle) throw FaultyInput(found);
    if (warnings)
      for (Finding& finding : FindingsOf(found)) warnings->push_back(std::move(finding));
    return Inside::Made(*std::move(vehicle));
  });
}

std::vector<Finding> CheckVehicle(const Vehicle& vehicle) {
  return Guarded([&] {
    Diagnostics found = LintDescription(Inside::Of(vehicle));
    found.Add(LintAssembled(Inside::Of(vehicle)));
    return FindingsOf(found);
  });
}

}  // namespace fourpost::api
