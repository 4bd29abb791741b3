#pragma once

#include <array>

namespace fourpost {

/// Adjustable monotube damper after appendix A of the thesis, which names its parts and three fitted parameters but not
/// its equations: those here, and the geometry, are a reconstruction. Extension x [m] from mid-stroke and rebound
/// positive, tension positive. Chambers: rebound (r, the annulus about the rod) and bump (c), which a massless floating
/// piston separates from trapped gas.
///   dP = P_r - P_c;  nominal mass flow m' = dP / (bleed sqrt(|dP| + rounding)) + dP / (rebound valve if dP > 0, else
///   bump valve);  volume flow Q = m' / density at the pressure upstream, Q exp(|dP| / K) downstream
///   P_r' = (A_a x' - Q_r) K / (V_r - A_a x)
///   P_c' = (Q_c - A_p x') / [V_oil / K + V_g / (gamma P_c)],  V_oil = V_c + A_p x + V_g0 - V_g
///   V_g = V_g0 (P_g0 / P_c)^(1/gamma)
///   f = P_r A_a - P_c A_p - P_g0 (A_a - A_p) + friction tanh(x' / friction speed)
/// Oil of density ~ exp(P / K) is conserved: with one Q for both chambers a cycle of work W would lose the volume W /
/// K, and the gas its pressure within a sweep. Chamber pressure is clamped at the vapour pressure. A P below it stands
/// for oil at that pressure and for vapour, which fills the share 1 - exp((P - P_cavitation) / K) of the chamber and
/// must vanish before the pressure rises. There the Q of the chamber's P counts its mean density. The default geometry:
/// bore 30 mm, rod 12.5 mm, 0.1 m from mid-stroke to either end.
struct HydraulicDamper {
  double bleed_resistance = 4e4;                  // Pa^0.5 / (kg/s), adjustable, turbulent, both directions
  double rebound_valve_resistance = 1e7;          // Pa / (kg/s), laminar
  double compression_valve_resistance = 2.597e6;  // Pa / (kg/s), laminar
  double bulk_modulus = 3e8;                      // Pa, K, of oil and tube
  double piston_area = 7.069e-4;                  // m^2, A_p
  double annulus_area = 5.841e-4;                 // m^2, A_a: the piston's less the rod's
  double rebound_volume = 5.841e-5;               // m^3, V_r at mid-stroke
  double compression_volume = 7.069e-5;           // m^3, V_c at mid-stroke
  double gas_pressure = 2e6;                      // Pa, P_g0 at mid-stroke
  double gas_volume = 60e-6;                      // m^3, V_g0 at mid-stroke
  double gas_exponent = 1.3;                      // gamma
  double density = 860;                           // kg/m^3
  double friction = 50;                           // N
  double friction_speed = 0.005;                  // m/s
  double cavitation_pressure = 5e3;               // Pa
  double bleed_rounding = 2e3;                    // Pa, keeps the bleed's slope finite at dP = 0

  /// {P_r, P_c} at rest at mid-stroke [Pa].
  std::array<double, 2> Rest() const { return {gas_pressure, gas_pressure}; }

  /// {P_r', P_c'} [Pa/s] at extension x, rate v and {P_r, P_c}. NaN if x closes a chamber.
  std::array<double, 2> PressureRates(double x, double v, const std::array<double, 2>& p) const;

  /// Energy that oil and gas store [J], relative to rest at mid-stroke, without the static force: per volume of oil
  /// (P_g0 + K) (e^u - 1) - K u with u = (P - P_g0) / K, for density ~ exp(P / K); for the gas (P_c V_g - P_g0 V_g0) /
  /// (gamma - 1). With it
  ///   Force v = d Energy / dt + Dissipation.
  double Energy(double x, const std::array<double, 2>& p) const;

  /// Power dissipated in the valves and by friction [W], not negative: K |Q_r - Q_c| is the loss of oil that flows to a
  /// lower pressure, |dP| Q for stiff oil.
  double Dissipation(double v, const std::array<double, 2>& p) const;

  /// Tension without the static force of the gas [N].
  double Force(double v, const std::array<double, 2>& p) const;

  /// Force [N] at mid-stroke of a slow cycle: constant v, stiff oil, gas at its pressure at rest. Used by linear
  /// models.
  double SteadyForce(double v) const;

  /// Mean rate of the steady force without friction, over the velocities of DashpotLaw::MeanRate [N s/m].
  double MeanRate() const;

  /// m' [kg/s] of the valves, and its slope [kg/(s Pa)].
  double MassFlow(double pressure_difference) const;
  double MassFlowSlope(double pressure_difference) const;

  /// V_g [m^3].
  double GasVolume(double pressure) const;

  /// All positive and finite, friction not negative, vapour pressure below gas pressure, annulus within the piston;
  /// else throws std::invalid_argument naming field, value and bound.
  void Validate() const;

  bool operator==(const HydraulicDamper&) const = default;

 private:
  /// Volume flow out of the rebound chamber and into the bump chamber [m^3/s].
  std::array<double, 2> Flows(double rebound_pressure, double compression_pressure) const;
  double ValveResistance(double pressure_difference) const;
  double Friction(double v) const;
  /// Energy of oil, per volume [J/m^3].
  double OilEnergy(double pressure) const;
  /// Energy of a chamber's content, per volume [J/m^3]; P as the pressures of a state.
  double ChamberEnergy(double p) const;
  /// Work done on the gas [J].
  double GasEnergy(double pressure) const;
};

}  // namespace fourpost
