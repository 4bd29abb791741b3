#pragma once

#include <array>

#include "vehicles/laws/mounted_hydraulic_damper.h"

namespace fourpost {

/// The equations of MountedHydraulicDamper, or of the damper alone, with a single state: as oil is conserved, one
/// number determines its distribution. With volumes of oil at its density at rest, the rebound chamber holds V_r - A_a
/// x + surplus, the bump chamber the rest of V_r + V_c;
///   surplus' = A_a x' - Q,   Q = m' / density
/// x: extension of damper and mount together; m': the valves' flow out of the rebound chamber, of oil at the density of
/// its source. Pressures and the damper's own extension follow from x and the surplus: from the oil in the chambers and
/// the mount's force. Excludes friction, which has no state.
class HydraulicOil {
 public:
  struct State {
    double surplus = 0;  // m^3
    /// P_r, P_c as in HydraulicDamper [Pa].
    std::array<double, 2> pressures{};
    double flow = 0;     // Q, m^3/s
    double tension = 0;  // N
  };
  /// Derivatives of a state.
  struct Slopes {
    double flow_by_surplus = 0;       // 1/s
    double flow_by_extension = 0;     // m^2/s
    double tension_by_surplus = 0;    // N/m^3
    double tension_by_extension = 0;  // N/m
  };

  /// Linearised tension about rest: a spring `stiffness`, the effect of gas on the rod, in parallel with a dashpot
  /// `rate` and spring `series` in series, the effect of oil and mount while no valve opens. Valves at
  /// HydraulicDamper::MeanRate.
  struct LinearShare {
    double stiffness = 0;  // N/m
    double rate = 0;       // N s/m
    double series = 0;     // N/m
  };

  explicit HydraulicOil(const MountedHydraulicDamper& damper) : law_(damper) {}

  /// Pressures as at rest, at the extension 0.
  State Rest() const;

  /// The state at extension x where share surplus + flow_share Q = target. (1, 0, surplus) gives the state of a
  /// surplus, (1 / h, 1, A_a x' + last surplus / h) the end of an implicit Euler step h. Neither share is negative. The
  /// search starts at `near`. NaN if x closes a chamber.
  State Find(double x, double surplus_share, double flow_share, double target, const State& near) const;

  Slopes SlopesAt(double x, const State& state) const;

  LinearShare Linear() const;

  const MountedHydraulicDamper& law() const { return law_; }

 private:
  /// For a, b: oil in the rebound and the bump chamber [m^3], flow and tension; derivatives by {P_r, P_c} and x.
  struct Balance {
    double rebound = 0;
    double compression = 0;
    double flow = 0;
    double tension = 0;
    std::array<double, 2> rebound_by{};
    std::array<double, 2> compression_by{};
    std::array<double, 2> flow_by{};
    std::array<double, 2> tension_by{};
    double rebound_by_extension = 0;
    double compression_by_extension = 0;
    bool is_rebound_open = false;
    bool is_compression_open = false;
  };
  Balance At(double x, const std::array<double, 2>& pressures) const;
  State StateAt(double x, const std::array<double, 2>& pressures) const;
  /// Find() by bisection, for cases in which Newton's method fails.
  State Search(double x, double surplus_share, double flow_share, double target, const State& near) const;
  double CompressionPressure(double x, double rebound_pressure, double start) const;
  double AllOil() const { return law_.damper.rebound_volume + law_.damper.compression_volume; }

  MountedHydraulicDamper law_;
};

}  // namespace fourpost
