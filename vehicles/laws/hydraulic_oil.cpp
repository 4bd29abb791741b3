#include "vehicles/laws/hydraulic_oil.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numerics/increasing_root.h"

namespace fourpost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Pressures are sought within this many bulk moduli: thinner oil than exp(-20) is none.
constexpr double kWidest = 20;

/// Last step of a pressure's search, as a share of that at rest; Newton's method squares what is left.
constexpr double kClose = 1e-8;

}  // namespace

HydraulicOil::State HydraulicOil::Rest() const { return {.pressures = law_.damper.Rest()}; }

HydraulicOil::Balance HydraulicOil::At(double x, const std::array<double, 2>& pressures) const {
  const HydraulicDamper& d = law_.damper;
  const double floor = d.cavitation_pressure;
  const std::array<double, 2> p = {std::max(pressures[0], floor), std::max(pressures[1], floor)};
  Balance out;
  out.tension = d.Force(0, pressures);
  out.tension_by = {pressures[0] < floor ? 0 : d.annulus_area, pressures[1] < floor ? 0 : -d.piston_area};
  double own = x;
  double yield = 0;
  if (law_.HasMount()) {
    const double mount = law_.MountExtension(pressures);
    own -= mount;
    yield = 1 / law_.mount.Slope(mount);
  }
  const double annulus = d.rebound_volume - d.annulus_area * own;
  const double gas = d.GasVolume(p[1]);
  const double bore = d.compression_volume + d.piston_area * own + d.gas_volume - gas;
  out.is_rebound_open = annulus > 0;
  out.is_compression_open = d.compression_volume + d.piston_area * own > 0;
  const auto density = [&](double pressure) { return std::exp((pressure - d.gas_pressure) / d.bulk_modulus); };
  const double above = density(pressures[0]);
  const double below = density(pressures[1]);
  out.rebound = above * annulus;
  out.compression = below * bore;
  out.rebound_by_extension = -above * d.annulus_area;
  out.compression_by_extension = below * d.piston_area;
  for (std::size_t i = 0; i < 2; ++i) {
    const double own_by = -yield * out.tension_by[i];
    out.rebound_by[i] = out.rebound_by_extension * own_by;
    out.compression_by[i] = out.compression_by_extension * own_by;
  }
  out.rebound_by[0] += out.rebound / d.bulk_modulus;
  out.compression_by[1] += out.compression / d.bulk_modulus;
  if (!(pressures[1] < floor)) out.compression_by[1] += below * gas / (d.gas_exponent * p[1]);
  const double difference = p[0] - p[1];
  const double upstream = density(std::max(p[0], p[1])) / d.density;
  const double slope = upstream * d.MassFlowSlope(difference);
  out.flow = upstream * d.MassFlow(difference);
  out.flow_by = {slope, -slope};
  out.flow_by[difference > 0 ? 0 : 1] += out.flow / d.bulk_modulus;
  for (std::size_t i = 0; i < 2; ++i)
    if (pressures[i] < floor) out.flow_by[i] = 0;
  return out;
}

/// The one at which both chambers hold all oil.
double HydraulicOil::CompressionPressure(double x, double rebound_pressure, double start) const {
  const auto oil = [&](double pressure) {
    const Balance at = At(x, {rebound_pressure, pressure});
    return std::pair(at.rebound + at.compression, at.rebound_by[1] + at.compression_by[1]);
  };
  const double widest = kWidest * law_.damper.bulk_modulus;
  return IncreasingRoot(oil, AllOil(), -widest, widest, start, kClose * law_.damper.gas_pressure);
}

HydraulicOil::State HydraulicOil::StateAt(double x, const std::array<double, 2>& pressures) const {
  const Balance at = At(x, pressures);
  return {.surplus = at.rebound - law_.damper.rebound_volume + law_.damper.annulus_area * x,
          .pressures = pressures,
          .flow = at.flow,
          .tension = at.tension};
}

// Next to an answer Newton's method for both pressures finds it with fewest evaluations.
HydraulicOil::State HydraulicOil::Find(double x, double surplus_share, double flow_share, double target,
                                       const State& near) const {
  constexpr int kMostSteps = 6;
  const HydraulicDamper& d = law_.damper;
  const double close = kClose * d.gas_pressure;
  std::array<double, 2> p = near.pressures;
  for (int i = 0; i < kMostSteps; ++i) {
    const Balance at = At(x, p);
    if (!at.is_rebound_open || !at.is_compression_open) break;
    const double surplus = at.rebound - d.rebound_volume + d.annulus_area * x;
    const double missing = target - surplus_share * surplus - flow_share * at.flow;
    const double oil = AllOil() - at.rebound - at.compression;
    const double a = surplus_share * at.rebound_by[0] + flow_share * at.flow_by[0];
    const double b = surplus_share * at.rebound_by[1] + flow_share * at.flow_by[1];
    const double e = at.rebound_by[0] + at.compression_by[0];
    const double f = at.rebound_by[1] + at.compression_by[1];
    const double determinant = a * f - b * e;
    const std::array<double, 2> step = {(f * missing - b * oil) / determinant, (a * oil - e * missing) / determinant};
    p = {p[0] + step[0], p[1] + step[1]};
    if (std::abs(step[0]) <= close && std::abs(step[1]) <= close) return StateAt(x, p);
  }
  return Search(x, surplus_share, flow_share, target, near);
}

// The surplus, and the flow, rise with the rebound pressure, the bump pressure following.
HydraulicOil::State HydraulicOil::Search(double x, double surplus_share, double flow_share, double target,
                                         const State& near) const {
  const HydraulicDamper& d = law_.damper;
  if (const Balance at = At(x, near.pressures); !law_.HasMount() && !(at.is_rebound_open && at.is_compression_open))
    return {.tension = kNan};
  std::array<double, 2> found = near.pressures;
  double turn = 0;
  const auto sum = [&](double pressure) {
    // A step of a root's search is a small one at its end: from there the other pressure follows along.
    const double start = found[1] + turn * (pressure - found[0]);
    const double compression = CompressionPressure(x, pressure, start);
    const Balance at = At(x, {pressure, compression});
    // The mount yields until a chamber is closed, or full of all the oil there is.
    if (!at.is_rebound_open) return std::pair(-kInfinity, 1.0);
    if (!at.is_compression_open || at.rebound >= AllOil()) return std::pair(kInfinity, 1.0);
    found = {pressure, compression};
    turn = -(at.rebound_by[0] + at.compression_by[0]) / (at.rebound_by[1] + at.compression_by[1]);
    const double surplus = at.rebound - d.rebound_volume + d.annulus_area * x;
    return std::pair(surplus_share * surplus + flow_share * at.flow,
                     surplus_share * (at.rebound_by[0] + turn * at.rebound_by[1]) +
                         flow_share * (at.flow_by[0] + turn * at.flow_by[1]));
  };
  const double widest = kWidest * d.bulk_modulus;
  const double rebound = IncreasingRoot(sum, target, -widest, widest, near.pressures[0], kClose * d.gas_pressure);
  return StateAt(x, {rebound, CompressionPressure(x, rebound, found[1] + turn * (rebound - found[0]))});
}

HydraulicOil::Slopes HydraulicOil::SlopesAt(double x, const State& state) const {
  const Balance at = At(x, state.pressures);
  const double determinant = at.rebound_by[0] * at.compression_by[1] - at.rebound_by[1] * at.compression_by[0];
  // Pressures by a change of what each chamber holds.
  const auto pressures_by = [&](double rebound, double compression) {
    return std::array<double, 2>{(at.compression_by[1] * rebound - at.rebound_by[1] * compression) / determinant,
                                 (at.rebound_by[0] * compression - at.compression_by[0] * rebound) / determinant};
  };
  const double area = law_.damper.annulus_area;
  const std::array<double, 2> by_surplus = pressures_by(1, -1);
  const std::array<double, 2> by_extension =
      pressures_by(-area - at.rebound_by_extension, area - at.compression_by_extension);
  const auto along = [](const std::array<double, 2>& slope, const std::array<double, 2>& way) {
    return slope[0] * way[0] + slope[1] * way[1];
  };
  return {.flow_by_surplus = along(at.flow_by, by_surplus),
          .flow_by_extension = along(at.flow_by, by_extension),
          .tension_by_surplus = along(at.tension_by, by_surplus),
          .tension_by_extension = along(at.tension_by, by_extension)};
}

// surplus' = A_a x' - flow_s surplus - flow_x x and tension_s surplus + tension_x x: without flow, and when it is over.
HydraulicOil::LinearShare HydraulicOil::Linear() const {
  const HydraulicDamper& d = law_.damper;
  const Slopes at = SlopesAt(0, Rest());
  const double stiffness = at.tension_by_extension - at.tension_by_surplus * at.flow_by_extension / at.flow_by_surplus;
  const double closed = at.tension_by_extension + at.tension_by_surplus * d.annulus_area;
  // Flow per pressure at rest, over that of the mean rate A_a^2 / conductance.
  const double conductance = d.MassFlowSlope(0) / d.density;
  const double stiffer = conductance * d.MeanRate() / (d.annulus_area * d.annulus_area);
  const double series = closed - stiffness;
  return {.stiffness = stiffness, .rate = stiffer * series / at.flow_by_surplus, .series = series};
}

}  // namespace fourpost
