#pragma once

#include <ostream>
#include <vector>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A damper's law by its name.
struct DamperLaw {
  const char* name;
  DashpotDescription law;
  /// On a mount of 150 kN/m.
  bool in_series = false;
};

inline std::ostream& operator<<(std::ostream& out, const DamperLaw& law) { return out << law.name; }

/// N s/m.
inline DashpotDescription Rates(double compression, double rebound) {
  return {.compression = {compression}, .rebound = {rebound}};
}

inline DashpotDescription WithFriction(double force_N) {
  DashpotDescription law = Rates(800, 2600);
  law.friction = DashpotDescription::Friction{{force_N}, {0.002}};
  return law;
}

inline DashpotDescription SmoothLaw() {
  return {.kind = DashpotDescription::Kind::kSmooth, .compression = {800}, .rebound = {2600}, .transition = {0.05}};
}

inline DashpotDescription DigressiveLaw() {
  return {.kind = DashpotDescription::Kind::kDigressive,
          .compression = {2000},
          .rebound = {4000},
          .compression_knee = {{0.05}, {500}},
          .rebound_knee = {{0.08}, {800}}};
}

inline DashpotDescription SaturatingLaw() {
  return {.kind = DashpotDescription::Kind::kSaturating,
          .compression = {2000},
          .rebound = {4000},
          .compression_knee = {{0.2}, {}},
          .rebound_knee = {{0.1}, {}}};
}

inline DashpotDescription TableLaw() {
  return {.kind = DashpotDescription::Kind::kTable,
          .table = {{{-0.5}, {-500}}, {{-0.1}, {-200}}, {{0.1}, {300}}, {{0.5}, {900}}}};
}

inline DashpotDescription CurveLaw() {
  return {.kind = DashpotDescription::Kind::kCurve,
          .segments = {{{-0.5}, {600}}, {{-0.1}, {2000}}, {{0.08}, {4000}}, {{0.5}, {1200}}}};
}

/// All kinds, alone and on a mount.
inline std::vector<DamperLaw> DamperLaws() {
  return {{"Bilinear", Rates(800, 2600)},  {"BilinearInSeries", Rates(800, 2600), true},
          {"Smooth", SmoothLaw()},         {"SmoothInSeries", SmoothLaw(), true},
          {"Digressive", DigressiveLaw()}, {"DigressiveInSeries", DigressiveLaw(), true},
          {"Saturating", SaturatingLaw()}, {"Table", TableLaw()},
          {"Curve", CurveLaw()},           {"CurveInSeries", CurveLaw(), true},
          {"Friction", WithFriction(50)},  {"FrictionInSeries", WithFriction(50), true}};
}

inline void SetLaw(const DamperLaw& law, Damper& damper) {
  damper.law = law.law;
  if (law.in_series) damper.series = SpringDescription{.stiffness = {150e3}};
}

inline Vehicle QuarterCarWith(const DamperLaw& law) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  SetLaw(law, vehicle.dampers[0]);
  return vehicle;
}

}  // namespace fourpost
