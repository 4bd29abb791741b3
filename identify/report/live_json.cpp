#include "identify/report/live_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/text/base64.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/condense.h"
#include "vehicles/condensed/reduced_bytes.h"
#include "vehicles/ride_metrics/ride_bytes.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// At full precision: what is set must be what was fitted.
OrderedJson Number(double value) { return std::isfinite(value) ? OrderedJson(value) : OrderedJson(); }

/// Place of a parameter among those of the vehicle.
std::size_t PlaceOf(const std::string& name, const std::vector<Parameter>& parameters) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  return static_cast<std::size_t>(found - parameters.begin());
}

OrderedJson UnitJson(const Parameter& parameter) {
  const std::optional<Unit> unit = ParseUnit(parameter.unit);
  return {{"index", 0}, {"name", parameter.name}, {"unit", parameter.unit}, {"si", unit ? unit->si : 1}};
}

OrderedJson FittedJson(const Parameter& parameter, const ReportedParameter& fitted) {
  OrderedJson json = UnitJson(parameter);
  json.update({{"value", Number(fitted.value)},
               {"start", Number(fitted.start)},
               {"lower", Number(fitted.lower)},
               {"upper", Number(fitted.upper)},
               {"interval_95", {Number(fitted.lower_95), Number(fitted.upper_95)}}});
  return json;
}

OrderedJson OtherJson(const Parameter& parameter) {
  OrderedJson json = UnitJson(parameter);
  const double si = json["si"];
  json.update({{"value", Number(parameter.value / si)},
               {"lower", Number(parameter.lower / si)},
               {"upper", Number(parameter.upper / si)}});
  return json;
}

/// Null where posts do not move the vehicle.
OrderedJson RideJson(const ShownRide& ride) {
  const RideInstruments& instruments = ride.instruments;
  if (instruments.vehicle.posts.empty()) return nullptr;
  OrderedJson points = OrderedJson::array();
  for (const RideInstruments::Felt& felt : instruments.points)
    points.push_back({{"name", felt.name}, {"weighting", WeightingName(felt.weighting)}});
  OrderedJson tyres = OrderedJson::array();
  for (const Tyre& tyre : instruments.vehicle.tyres) tyres.push_back(tyre.name);
  OrderedJson dampers = OrderedJson::array();
  for (const Damper& damper : instruments.vehicle.dampers) dampers.push_back(damper.name);
  return {{"instruments", Base64(BytesOf(instruments))},
          {"points", std::move(points)},
          {"tyres", std::move(tyres)},
          {"dampers", std::move(dampers)},
          {"road", ride.road_class},
          {"speed", ride.speed},
          {"band_Hz", {ride.lower_Hz, ride.upper_Hz}}};
}

OrderedJson VehicleJson(const Vehicle& vehicle, const std::optional<ShownRide>& asked) {
  const ShownRide ride = asked ? *asked : ShownRide{.instruments = InstrumentRide(vehicle)};
  const OrderedJson json = RideJson(ride);
  const Vehicle& reduced = json.is_null() ? vehicle : ride.instruments.vehicle;
  return {{"vehicle", Base64(BytesOf(Condense(reduced).data()))}, {"ride", json}};
}

}  // namespace

OrderedJson LiveJson(const RunContents& run, const std::vector<ReportedParameter>& fitted,
                     const std::optional<ShownRide>& ride) {
  if (!run.vehicle) return nullptr;
  const std::vector<Parameter>& parameters = run.vehicle->parameters;
  OrderedJson list = OrderedJson::array();
  std::vector<bool> is_fitted(parameters.size(), false);
  const auto add = [&](OrderedJson json, std::size_t place) {
    json["index"] = place;
    list.push_back(std::move(json));
  };
  for (const ReportedParameter& parameter : fitted) {
    const std::size_t place = PlaceOf(parameter.name, parameters);
    if (place == parameters.size()) return nullptr;
    is_fitted[place] = true;
    add(FittedJson(parameters[place], parameter), place);
  }
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (!is_fitted[i]) add(OtherJson(parameters[i]), i);
  if (list.empty()) return nullptr;
  try {
    const auto file = run.files.find("vehicle.urdf");
    OrderedJson json = VehicleJson(*run.vehicle, ride);
    json["file"] = file == run.files.end() ? OrderedJson() : OrderedJson(file->second);
    json["parameters"] = std::move(list);
    return json;
  } catch (const FaultyInput&) {
    return nullptr;  // The page says at the vehicle's picture why.
  }
}

}  // namespace fourpost
