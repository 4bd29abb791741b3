#pragma once

#include <array>
#include <concepts>
#include <type_traits>

#include "vehicles/condensed/reduced_data.h"

namespace fourpost {

/// What a reduced vehicle is stored by: `field(name, member)` of each member that matters to it, in the order in which
/// they are stored; `field.Choice(name, member, names)` of an enumeration. One list for all that write and read.
template <typename T, typename Record>
concept MaybeConst = std::same_as<std::remove_const_t<T>, Record>;

void EachField(MaybeConst<SpringDescription::Knee> auto& knee, auto&& field) {
  field("side", knee.side);
  field("at", knee.at);
  field("rate", knee.rate);
  field("cubic", knee.cubic);
  field("adds", knee.adds);
}

void EachField(MaybeConst<SpringDescription::TablePoint> auto& point, auto&& field) {
  field("extension", point.extension);
  field("force", point.force);
}

void EachField(MaybeConst<SpringDescription> auto& law, auto&& field) {
  field("stiffness", law.stiffness);
  field("cubic", law.cubic);
  field("knees", law.knees);
  field("table", law.table);
  field("place", law.place);
}

void EachField(MaybeConst<TyreDescription::TablePoint> auto& point, auto&& field) {
  field("deflection", point.deflection);
  field("force", point.force);
}

void EachField(MaybeConst<TyreDescription> auto& law, auto&& field) {
  field("stiffness", law.stiffness);
  field("progression", law.progression);
  field("table", law.table);
}

void EachField(MaybeConst<DashpotDescription::Knee> auto& knee, auto&& field) {
  field("speed", knee.speed);
  field("rate", knee.rate);
}

void EachField(MaybeConst<DashpotDescription::TablePoint> auto& point, auto&& field) {
  field("speed", point.speed);
  field("force", point.force);
}

void EachField(MaybeConst<DashpotDescription::Segment> auto& segment, auto&& field) {
  field("to", segment.to);
  field("rate", segment.rate);
}

void EachField(MaybeConst<DashpotDescription::Friction> auto& friction, auto&& field) {
  field("force", friction.force);
  field("speed", friction.speed);
  field("stiffness", friction.stiffness);
}

void EachField(MaybeConst<DashpotDescription> auto& law, auto&& field) {
  // As DashpotDescription::Kind.
  static constexpr std::array<const char*, 6> kKinds = {"bilinear",   "smooth", "digressive",
                                                        "saturating", "table",  "curve"};
  field.Choice("kind", law.kind, kKinds);
  field("compression", law.compression);
  field("rebound", law.rebound);
  field("transition", law.transition);
  field("compression_knee", law.compression_knee);
  field("rebound_knee", law.rebound_knee);
  field("table", law.table);
  field("segments", law.segments);
  field("friction", law.friction);
}

void EachField(MaybeConst<HydraulicDescription> auto& law, auto&& field) {
  field("bleed", law.bleed);
  field("rebound_valve", law.rebound_valve);
  field("compression_valve", law.compression_valve);
  field("bulk_modulus", law.bulk_modulus);
  field("piston_diameter", law.piston_diameter);
  field("rod_diameter", law.rod_diameter);
  field("rebound_column", law.rebound_column);
  field("compression_column", law.compression_column);
  field("gas_pressure", law.gas_pressure);
  field("gas_volume", law.gas_volume);
  field("gas_exponent", law.gas_exponent);
  field("density", law.density);
  field("cavitation", law.cavitation);
}

void EachField(MaybeConst<Parameter> auto& parameter, auto&& field) {
  field("name", parameter.name);
  field("value", parameter.value);
  field("lower", parameter.lower);
  field("upper", parameter.upper);
  field("unit", parameter.unit);
}

void EachField(MaybeConst<Sensor> auto& sensor, auto&& field) {
  // As Sensor::Type.
  static constexpr std::array<const char*, 5> kTypes = {"accelerometer", "displacement", "strut", "load_cell", "gyro"};
  field("name", sensor.name);
  field.Choice("type", sensor.type, kTypes);
  field("tyre", sensor.tyre);
  field("wheelpan", sensor.wheelpan);
}

void EachField(MaybeConst<DesignShape> auto& shape, auto&& field) {
  field("value", shape.value);
  field("gradient", shape.gradient);
  field("curvature", shape.curvature);
}

void EachField(MaybeConst<ReducedData::Body> auto& body, auto&& field) {
  field("name", body.name);
  field("mass", body.mass);
  field("com", body.com);
  field("inertia", body.inertia);
  field("place", body.place);
  field("com_jacobian", body.com_jacobian);
  field("spin_jacobian", body.spin_jacobian);
  field("weight", body.weight);
  field("weight_stiffness", body.weight_stiffness);
}

void EachField(MaybeConst<ReducedData::Held> auto& held, auto&& field) {
  field("length", held.shape);
  field("law", held.law);
  field("preload", held.preload);
  field("free_length", held.free_length);
}

void EachField(MaybeConst<ReducedData::Tyre> auto& tyre, auto&& field) {
  field("damping", tyre.damping);
  field("curve", tyre.curve);
  field("lifts_off", tyre.lifts_off);
  field("post", tyre.post);
}

void EachField(MaybeConst<ReducedData::Bond> auto& bond, auto&& field) {
  field("stiffness", bond.stiffness);
  field("damping", bond.damping);
  field("loss_time", bond.loss_time);
  field("direction", bond.direction);
}

void EachField(MaybeConst<ReducedData::Damper> auto& damper, auto&& field) {
  field("direction", damper.direction);
  field("law", damper.law);
  field("series", damper.series);
  field("hydraulic", damper.hydraulic);
}

void EachField(MaybeConst<ReducedData> auto& data, auto&& field) {
  field("vehicle", data.name);
  field("coordinates", data.coordinates);
  field("parameters", data.parameters);
  field("posts", data.posts);
  field("sensors", data.sensors);
  field("bodies", data.bodies);
  field("springs", data.springs);
  field("held", data.held);
  field("tyres", data.tyres);
  field("bushings_hold", data.bushings);
  field("bonds", data.bonds);
  field("dampers", data.dampers);
  field("actuators", data.actuators);
  field("on_position", data.on_position);
  field("on_velocity", data.on_velocity);
  field("on_acceleration", data.on_acceleration);
}

}  // namespace fourpost
