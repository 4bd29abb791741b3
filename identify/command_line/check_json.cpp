#include "identify/command_line/check_json.h"

#include <numbers>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "identify/command_line/check_text.h"
#include "vehicles/requests/channel_json.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json Vector(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json TreeJson(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  const auto link = [&](int index) -> const Link& { return vehicle.links[static_cast<std::size_t>(index)]; };
  Json tree = Json::array();
  for (const Joint& joint : vehicle.joints)
    tree.push_back({{"link", link(joint.child).name},
                    {"parent", link(joint.parent).name},
                    {"joint", joint.name},
                    {"motion", DescribeJoint(joint)},
                    {"mass_kg", link(joint.child).mass.At(values)}});
  return tree;
}

template <typename Element>
void AddClosures(const Vehicle& vehicle, const char* kind, const std::vector<Element>& elements, Json& json) {
  const auto link = [&](const Point& point) { return vehicle.links[static_cast<std::size_t>(point.link)].name; };
  for (const Element& element : elements)
    json.push_back(
        {{"name", element.name}, {"kind", kind}, {"parent", link(element.parent)}, {"child", link(element.child)}});
}

Json ClosuresJson(const Vehicle& vehicle) {
  Json closures = Json::array();
  AddClosures(vehicle, "rod", vehicle.rods, closures);
  AddClosures(vehicle, "ball", vehicle.balls, closures);
  AddClosures(vehicle, "hinge", vehicle.hinges, closures);
  AddClosures(vehicle, "weld", vehicle.welds, closures);
  return closures;
}

Json Bushings(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  Json bushings = Json::array();
  AddClosures(vehicle, "bushing", vehicle.bushings, bushings);
  for (std::size_t i = 0; i < bushings.size(); ++i) {
    const Bushing& bushing = vehicle.bushings[i];
    for (std::size_t k = 0; k < 3; ++k) {
      bushings[i]["stiffness_N_per_m"].push_back(bushing.stiffness[k].At(values));
      bushings[i]["damping_Ns_per_m"].push_back(bushing.DampingAt(k, values));
      bushings[i]["rotational_stiffness_Nm_per_rad"].push_back(bushing.stiffness[k + 3].At(values));
      bushings[i]["rotational_damping_Nms_per_rad"].push_back(bushing.DampingAt(k + 3, values));
    }
    bushings[i]["holds_design_pose"] = bushing.holds;
  }
  return bushings;
}

Json PostsJson(const Vehicle& vehicle) {
  Json posts = Json::array();
  for (const Post& post : vehicle.posts)
    posts.push_back({{"name", post.name},
                     {"tyre", vehicle.tyres[static_cast<std::size_t>(post.tyre)].name},
                     {"stroke_m", OrNull(post.stroke)}});
  return posts;
}

Json SensorOf(const Vehicle& vehicle, const Sensor& sensor) {
  const auto link = [&](const Point& point) { return vehicle.links[static_cast<std::size_t>(point.link)].name; };
  Json json = {{"name", sensor.name}, {"kind", KindName(sensor.type)}};
  switch (sensor.type) {
    case Sensor::Type::kAccelerometer:
    case Sensor::Type::kDisplacement: json["xyz_m"] = Vector(sensor.point.xyz); [[fallthrough]];
    case Sensor::Type::kGyro:
      json["link"] = link(sensor.point);
      json["axis"] = Vector(sensor.axis);
      break;
    case Sensor::Type::kStrut:
      json["parent"] = link(sensor.line.parent);
      json["child"] = link(sensor.line.child);
      break;
    case Sensor::Type::kLoadCell:
      json["tyre"] = vehicle.tyres[static_cast<std::size_t>(sensor.tyre)].name;
      json["wheelpan_kg"] = sensor.wheelpan.At(vehicle.ParameterValues());
      break;
  }
  return json;
}

Json SensorsJson(const Vehicle& vehicle) {
  Json sensors = Json::array();
  for (const Sensor& sensor : vehicle.sensors) sensors.push_back(SensorOf(vehicle, sensor));
  return sensors;
}

Json Inertia(const Eigen::Matrix3d& inertia) {
  return {{"Ixx", inertia(0, 0)}, {"Iyy", inertia(1, 1)}, {"Izz", inertia(2, 2)},
          {"Ixy", inertia(0, 1)}, {"Ixz", inertia(0, 2)}, {"Iyz", inertia(1, 2)}};
}

/// A rate without bound is written as null.
Json Rates(const WheelRates::Rates& rates) {
  return {{"wheel_rate_N_per_m", rates.wheel_Npm}, {"ride_rate_N_per_m", rates.ride_Npm}};
}

Json Corners(const VehicleSummary& summary) {
  Json corners = Json::array();
  for (std::size_t i = 0; i < summary.suspension.wheels.size(); ++i) {
    const WheelRates& rates = summary.ride.wheels[i];
    const CornerNumbers& corner = summary.chassis.corners[i];
    corners.push_back(
        {{"name", summary.suspension.wheels[i].name},
         {"load_N", summary.corner_loads[i].load_N},
         {"tyre_rate_N_per_m", rates.tyre_Npm},
         {"alone", Rates(rates.alone)},
         {"together", Rates(rates.together)},
         {"sprung_mass_kg", OrNull(corner.sprung_kg)},
         {"damping_N_s_per_m", {{"bump", corner.bump_Nspm}, {"rebound", corner.rebound_Nspm}}},
         {"damping_ratio", {{"bump", OrNull(corner.bump_ratio)}, {"rebound", OrNull(corner.rebound_ratio)}}}});
  }
  return corners;
}

Json AxlesJson(const VehicleSummary& summary) {
  Json axles = Json::array();
  for (std::size_t a = 0; a < summary.suspension.axles.size(); ++a) {
    const AxleNumbers& axle = summary.chassis.axles[a];
    Json tyres = Json::array();
    for (const std::size_t i : summary.suspension.axles[a].wheels) tyres.push_back(summary.suspension.wheels[i].name);
    axles.push_back({{"name", summary.suspension.axles[a].name},
                     {"tyres", tyres},
                     {"load_N", axle.load_N},
                     {"sprung_mass_kg", OrNull(axle.sprung_kg)},
                     {"unsprung_mass_kg", OrNull(axle.unsprung_kg)},
                     {"ride_frequency_Hz", OrNull(axle.ride_Hz)},
                     {"hop_frequency_Hz", OrNull(axle.hop_Hz)},
                     {"roll_stiffness_Nm_per_rad", OrNull(summary.ride.axles[a].roll_Nm)},
                     {"elastic_roll_stiffness_Nm_per_rad", OrNull(axle.elastic_roll_Nm)},
                     {"roll_stiffness_on_tyres_Nm_per_rad", OrNull(axle.roll_on_tyres_Nm)},
                     {"roll_centre_height_m", OrNull(axle.roll_centre_m)},
                     {"is_beam", axle.is_beam},
                     {"braking_support", axle.braking_support},
                     {"driving_support", axle.driving_support},
                     {"anti_braking", OrNull(axle.anti_braking)},
                     {"anti_driving", OrNull(axle.anti_driving)},
                     {"load_transfer_N_per_m_per_s2", OrNull(axle.load_transfer)},
                     {"load_transfer_share", OrNull(axle.load_transfer_share)}});
  }
  return axles;
}

Json Handling(const ChassisNumbers& chassis) {
  Json pitch_centre;
  if (chassis.pitch_centre) pitch_centre = {chassis.pitch_centre->x, chassis.pitch_centre->z};
  return {
      {"wheelbase_m", OrNull(chassis.wheelbase_m)}, {"com_height_m", OrNull(chassis.com_height_m)},
      {"left_share", OrNull(chassis.left_share)},   {"cross_weight", OrNull(chassis.cross_weight)},
      {"roll_arm_m", OrNull(chassis.roll_arm_m)},   {"roll_gradient_rad_per_m_per_s2", OrNull(chassis.roll_gradient)},
      {"pitch_centre_xz_m", pitch_centre}};
}

Json Strut(const VehicleSummary& summary, const std::string& element, const StrutGeometry& strut, const char* rate) {
  const bool is_moved = strut.wheel >= 0;
  const auto wheel = static_cast<std::size_t>(strut.wheel);
  return {{"element", element},
          {"length_m", strut.length_m},
          {rate, strut.rate},
          {"moved_by", is_moved ? Json(summary.suspension.wheels[wheel].name) : Json()},
          {"motion_ratio_alone", OrNull(strut.alone)},
          {"motion_ratio_together", OrNull(strut.together)}};
}

Json Struts(const Vehicle& vehicle, const VehicleSummary& summary) {
  Json struts = Json::array();
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    struts.push_back(Strut(summary, vehicle.springs[i].Element(), summary.ride.springs[i], "rate_N_per_m"));
    struts.back()["tension_N"] = summary.spring_tension[i];
  }
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i)
    struts.push_back(
        Strut(summary, "fp:damper '" + vehicle.dampers[i].name + "'", summary.ride.dampers[i], "mean_rate_Ns_per_m"));
  for (std::size_t i = 0; i < vehicle.antiroll_bars.size(); ++i)
    struts.push_back(Strut(summary, "fp:antiroll '" + vehicle.antiroll_bars[i].name + "'",
                           summary.ride.antiroll_bars[i], "rate_N_per_m"));
  return struts;
}

Json Modes(const std::vector<Mode>& of) {
  Json modes = Json::array();
  for (const Mode& mode : of) {
    Json energy = Json::object();
    for (const MotionShare& part : mode.energy) energy[part.motion] = part.share;
    modes.push_back({{"name", mode.name},
                     {"kind", KindName(mode.kind)},
                     {"frequency_Hz", mode.frequency_Hz},
                     {"damped_frequency_Hz", mode.pole.imag() / (2 * std::numbers::pi)},
                     {"damping_ratio", mode.damping_ratio},
                     {"kinetic_energy", energy}});
  }
  return modes;
}

Json ParametersJson(const Vehicle& vehicle) {
  Json parameters = Json::array();
  for (const Parameter& parameter : vehicle.parameters) {
    parameters.push_back({{"name", parameter.name},
                          {"value", parameter.value},
                          {"unit", SiUnit(parameter.dimension)},
                          {"lower", parameter.lower},
                          {"upper", parameter.upper},
                          {"precision", parameter.precision},
                          {"prior_sd", OrNull(parameter.prior_sd)},
                          {"source", parameter.source}});
    if (parameter.like)
      parameters.back()["like"] = {{"parameter", parameter.like->parameter}, {"sd", parameter.like->sd}};
  }
  return parameters;
}

Json ViewsJson(const VehicleSummary& summary) {
  Json views = Json::array();
  for (const ParameterView& view : summary.views) {
    Json channels = Json::array();
    for (const ParameterView::Channel& channel : view.channels)
      channels.push_back({{"sensor", channel.sensor},
                          {"excitation", channel.excitation},
                          {"relative_sensitivity", channel.sensitivity}});
    views.push_back({{"parameter", view.parameter}, {"in_curved_law", view.in_curved_law}, {"channels", channels}});
  }
  return views;
}

Json Told(const CheckedVehicle& checked) {
  const auto& [vehicle, mobility, summary] = checked;
  return {{"name", vehicle.name},
          {"dof", summary.dof},
          {"mobility",
           {{"joint_coordinates", mobility.joint_coordinates},
            {"loop_equations", mobility.loop_equations},
            {"independent_equations", mobility.independent_equations},
            {"redundant", mobility.redundant},
            {"loop_residual_m", mobility.loop_residual}}},
          {"tree", TreeJson(vehicle)},
          {"loop_closures", ClosuresJson(vehicle)},
          {"bushings", Bushings(vehicle)},
          {"mass_kg", summary.mass_kg},
          {"sprung_mass_kg", OrNull(summary.SprungMass_kg())},
          {"unsprung_mass_kg", OrNull(summary.ride.unsprung_mass_kg)},
          {"com_m", Vector(summary.com)},
          {"inertia_kg_m2", Inertia(summary.inertia)},
          {"weight_N", summary.Weight_N()},
          {"corners", Corners(summary)},
          {"axles", AxlesJson(summary)},
          {"handling", Handling(summary.chassis)},
          {"struts", Struts(vehicle, summary)},
          {"modes", Modes(summary.modes)},
          {"stuck_modes", Modes(summary.stuck_modes)},
          {"stable", summary.IsStable()},
          {"posts", PostsJson(vehicle)},
          {"sensors", SensorsJson(vehicle)},
          {"parameters", ParametersJson(vehicle)},
          {"observability", ViewsJson(summary)}};
}

}  // namespace

std::string CheckJson(const std::optional<CheckedVehicle>& checked, const Diagnostics& findings) {
  Json json = checked ? Told(*checked) : Json::object();
  json["findings"] = FindingsJson(findings);
  // A file's name may be no UTF-8.
  return JsonText(json);
}

}  // namespace fourpost
