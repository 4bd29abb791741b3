#include "vehicles/description/element_laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace fourpost {

SpringLaw SpringDescription::At(std::span<const double> parameters) const {
  SpringLaw law{.stiffness = stiffness.At(parameters), .cubic = cubic.At(parameters), .knees = {}};
  // The rate that the next knee of a side replaces.
  std::array<double, 2> rate = {law.stiffness, law.stiffness};
  for (const Knee& knee : knees) {
    double& before = rate[knee.side > 0 ? 1 : 0];
    const double given = knee.rate.At(parameters);
    law.knees.push_back({.at = knee.side * knee.at.At(parameters),
                         .side = knee.side,
                         .stiffness = knee.adds ? given : given - before,
                         .cubic = knee.cubic.At(parameters)});
    if (!knee.adds) before = given;
  }
  if (table.empty()) return law;
  std::vector<double> extensions;
  std::vector<double> forces;
  for (const TablePoint& point : table) {
    extensions.push_back(point.extension.At(parameters) - place.At(parameters));
    forces.push_back(point.force.At(parameters));
  }
  law.curve.emplace(std::move(extensions), std::move(forces), "SpringLaw: extension", "SpringLaw: force");
  return law;
}

TyreLaw TyreDescription::At(std::span<const double> parameters) const {
  TyreLaw law{.stiffness = stiffness.At(parameters), .progression = progression.At(parameters)};
  if (table.empty()) return law;
  std::vector<double> deflections;
  std::vector<double> forces;
  for (const TablePoint& point : table) {
    deflections.push_back(point.deflection.At(parameters));
    forces.push_back(point.force.At(parameters));
  }
  law.curve.emplace(std::move(deflections), std::move(forces), "TyreLaw: deflection", "TyreLaw: force");
  return law;
}

double TyreDescription::RateAt(std::span<const double> parameters, double load) const {
  return At(parameters).Under(load).Rate(0);
}

double SpringDescription::RateAt(std::span<const double> parameters) const {
  return table.empty() ? stiffness.At(parameters) : At(parameters).Slope(0);
}

namespace {

DashpotLaw Curve(const std::vector<DashpotDescription::Segment>& segments, std::span<const double> parameters) {
  const auto count = segments.size();
  std::vector<double> speeds(count);
  std::vector<double> forces(count);
  for (std::size_t i = 0; i < count; ++i) speeds[i] = segments[i].to.At(parameters);
  // Outward from rest.
  const auto end = [&](std::size_t i, bool is_first, std::size_t inner) {
    const double from = is_first ? 0 : speeds[inner];
    forces[i] = (is_first ? 0 : forces[inner]) + segments[i].rate.At(parameters) * (speeds[i] - from);
  };
  const auto bumps =
      static_cast<std::size_t>(std::count_if(speeds.begin(), speeds.end(), [](double speed) { return speed < 0; }));
  for (std::size_t i = bumps; i-- > 0;) end(i, i + 1 == bumps, i + 1);
  for (std::size_t i = bumps; i < count; ++i) end(i, i == bumps, i - 1);
  return DashpotLaw::Table(std::move(speeds), std::move(forces));
}

}  // namespace

DashpotLaw DashpotDescription::At(std::span<const double> parameters) const {
  const auto bare = [&]() -> DashpotLaw {
    const double bump = compression.At(parameters);
    const double pull = rebound.At(parameters);
    const auto knee = [&](const Knee& at) {
      return DashpotLaw::Knee{.speed = at.speed.At(parameters), .rate = at.rate.At(parameters)};
    };
    switch (kind) {
      case Kind::kBilinear: break;
      case Kind::kSmooth: return DashpotLaw::Smooth(bump, pull, transition.At(parameters));
      case Kind::kDigressive: return DashpotLaw::Digressive(bump, pull, knee(compression_knee), knee(rebound_knee));
      case Kind::kSaturating:
        return DashpotLaw::Saturating(bump, pull, knee(compression_knee).speed, knee(rebound_knee).speed);
      case Kind::kTable: {
        std::vector<double> speeds;
        std::vector<double> forces;
        for (const TablePoint& point : table) {
          speeds.push_back(point.speed.At(parameters));
          forces.push_back(point.force.At(parameters));
        }
        return DashpotLaw::Table(std::move(speeds), std::move(forces));
      }
      case Kind::kCurve: return Curve(segments, parameters);
    }
    return {bump, pull};
  };
  if (!friction || Sticks()) return bare();
  return bare().WithFriction(friction->force.At(parameters), friction->speed.At(parameters));
}

std::optional<DahlFriction> DashpotDescription::StickingAt(std::span<const double> parameters) const {
  if (!Sticks()) return std::nullopt;
  const DahlFriction law{.force = friction->force.At(parameters), .stiffness = friction->stiffness->At(parameters)};
  law.Validate();
  return law;
}

HydraulicDamper HydraulicDescription::At(std::span<const double> parameters) const {
  const auto disc = [&](const Scalar& diameter) {
    const double d = diameter.At(parameters);
    return std::numbers::pi / 4 * d * d;
  };
  HydraulicDamper damper;
  damper.density = density.At(parameters);
  // Through an orifice m' = Cd A sqrt(2 density dP).
  damper.bleed_resistance = 1 / (bleed.At(parameters) * std::sqrt(2 * damper.density));
  damper.rebound_valve_resistance = rebound_valve.At(parameters);
  damper.compression_valve_resistance = compression_valve.At(parameters);
  damper.bulk_modulus = bulk_modulus.At(parameters);
  damper.piston_area = disc(piston_diameter);
  damper.annulus_area = disc(piston_diameter) - disc(rod_diameter);
  damper.rebound_volume = damper.annulus_area * rebound_column.At(parameters);
  damper.compression_volume = damper.piston_area * compression_column.At(parameters);
  damper.gas_pressure = gas_pressure.At(parameters);
  damper.gas_volume = gas_volume.At(parameters);
  damper.gas_exponent = gas_exponent.At(parameters);
  damper.cavitation_pressure = cavitation.At(parameters);
  return damper;
}

}  // namespace fourpost
