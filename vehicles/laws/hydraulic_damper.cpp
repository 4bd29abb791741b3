#include "vehicles/laws/hydraulic_damper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "analysis/numerics/increasing_root.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

void RequireField(const std::string& field, double value) { RequirePositive("HydraulicDamper: " + field, value); }

}  // namespace

std::array<double, 2> HydraulicDamper::PressureRates(double x, double v, const std::array<double, 2>& p) const {
  const double rebound = rebound_volume - annulus_area * x;
  const double compression = compression_volume + piston_area * x;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (!(rebound > 0 && compression > 0)) return {kNan, kNan};
  const double rebound_pressure = std::max(p[0], cavitation_pressure);
  const double compression_pressure = std::max(p[1], cavitation_pressure);
  const std::array<double, 2> flow = Flows(rebound_pressure, compression_pressure);
  const double gas = GasVolume(compression_pressure);
  const double oil = compression + gas_volume - gas;
  // Gas at the pressure of vapour keeps its volume.
  const double gas_compliance = p[1] < cavitation_pressure ? 0 : gas / (gas_exponent * compression_pressure);
  // What flows counts more of the chamber's volume where vapour thins its content.
  const double thinned_out = flow[0] * std::exp((rebound_pressure - p[0]) / bulk_modulus);
  const double thinned_in = flow[1] * std::exp((compression_pressure - p[1]) / bulk_modulus);
  return {bulk_modulus / rebound * (annulus_area * v - thinned_out),
          (thinned_in - piston_area * v) / (oil / bulk_modulus + gas_compliance)};
}

double HydraulicDamper::Force(double v, const std::array<double, 2>& p) const {
  const double rebound = std::max(p[0], cavitation_pressure) - gas_pressure;
  const double compression = std::max(p[1], cavitation_pressure) - gas_pressure;
  return rebound * annulus_area - compression * piston_area + Friction(v);
}

double HydraulicDamper::Energy(double x, const std::array<double, 2>& p) const {
  const double compression = std::max(p[1], cavitation_pressure);
  const double above = rebound_volume - annulus_area * x;
  const double below = compression_volume + piston_area * x + gas_volume - GasVolume(compression);
  return above * ChamberEnergy(p[0]) + below * ChamberEnergy(p[1]) + GasEnergy(compression) -
         gas_pressure * (annulus_area - piston_area) * x;
}

double HydraulicDamper::Dissipation(double v, const std::array<double, 2>& p) const {
  const std::array<double, 2> flow = Flows(std::max(p[0], cavitation_pressure), std::max(p[1], cavitation_pressure));
  return bulk_modulus * std::abs(flow[0] - flow[1]) + Friction(v) * v;
}

double HydraulicDamper::OilEnergy(double pressure) const {
  const double u = (pressure - gas_pressure) / bulk_modulus;
  return (gas_pressure + bulk_modulus) * std::expm1(u) - bulk_modulus * u;
}

// Vapour has taken its place against the pressure of cavitation.
double HydraulicDamper::ChamberEnergy(double p) const {
  const double pressure = std::max(p, cavitation_pressure);
  const double oil = std::exp((p - pressure) / bulk_modulus);
  return oil * OilEnergy(pressure) - (1 - oil) * pressure;
}

double HydraulicDamper::GasVolume(double pressure) const {
  return gas_volume * std::pow(gas_pressure / pressure, 1 / gas_exponent);
}

double HydraulicDamper::GasEnergy(double pressure) const {
  const double rise = std::log(pressure / gas_pressure);
  const double share = 1 - 1 / gas_exponent;
  // As share goes to 0: gas of constant temperature.
  return gas_pressure * gas_volume / gas_exponent * (share == 0 ? rise : std::expm1(share * rise) / share);
}

double HydraulicDamper::SteadyForce(double v) const {
  const double flow = density * annulus_area * v;
  // The linear valve alone would need at least this much.
  const double most = flow * ValveResistance(flow);
  const auto orifices = [this](double p) { return std::pair(MassFlow(p), MassFlowSlope(p)); };
  const double difference = IncreasingRoot(orifices, flow, std::min(most, 0.0), std::max(most, 0.0), most);
  return std::max(difference, cavitation_pressure - gas_pressure) * annulus_area + Friction(v);
}

double HydraulicDamper::MeanRate() const {
  constexpr double kSpeed = 0.1;
  const double both = SteadyForce(kSpeed) - Friction(kSpeed) - (SteadyForce(-kSpeed) - Friction(-kSpeed));
  return both / (2 * kSpeed);
}

// The valves pass what leaves the upper pressure, by volume; in the other chamber it fills more.
std::array<double, 2> HydraulicDamper::Flows(double rebound_pressure, double compression_pressure) const {
  const double difference = rebound_pressure - compression_pressure;
  const double upstream = MassFlow(difference) / density;
  const double downstream = upstream * std::exp(std::abs(difference) / bulk_modulus);
  if (difference > 0) return {upstream, downstream};
  return {downstream, upstream};
}

double HydraulicDamper::MassFlow(double pressure_difference) const {
  const double bleed =
      pressure_difference / (bleed_resistance * std::sqrt(std::abs(pressure_difference) + bleed_rounding));
  return bleed + pressure_difference / ValveResistance(pressure_difference);
}

double HydraulicDamper::MassFlowSlope(double pressure_difference) const {
  const double size = std::abs(pressure_difference);
  const double root = std::sqrt(size + bleed_rounding);
  const double bleed = (0.5 * size + bleed_rounding) / (bleed_resistance * root * root * root);
  return bleed + 1 / ValveResistance(pressure_difference);
}

double HydraulicDamper::ValveResistance(double pressure_difference) const {
  return pressure_difference > 0 ? rebound_valve_resistance : compression_valve_resistance;
}

double HydraulicDamper::Friction(double v) const { return friction * std::tanh(v / friction_speed); }

void HydraulicDamper::Validate() const {
  RequireField("bleed_resistance", bleed_resistance);
  RequireField("rebound_valve_resistance", rebound_valve_resistance);
  RequireField("bump_valve_resistance", compression_valve_resistance);
  RequireField("bulk_modulus", bulk_modulus);
  RequireField("piston_area", piston_area);
  RequireOption(annulus_area > 0 && annulus_area <= piston_area, "HydraulicDamper: annulus_area", annulus_area,
                "positive and at most piston_area");
  RequireField("rebound_volume", rebound_volume);
  RequireField("bump_volume", compression_volume);
  RequireField("gas_pressure", gas_pressure);
  RequireField("gas_volume", gas_volume);
  RequireField("gas_exponent", gas_exponent);
  RequireField("density", density);
  RequireOption(friction >= 0 && std::isfinite(friction), "HydraulicDamper: friction", friction,
                "finite and not negative");
  RequireField("friction_speed", friction_speed);
  RequireOption(cavitation_pressure > 0 && cavitation_pressure < gas_pressure, "HydraulicDamper: cavitation_pressure",
                cavitation_pressure, "positive and below gas_pressure");
  RequireField("bleed_rounding", bleed_rounding);
}

}  // namespace fourpost
