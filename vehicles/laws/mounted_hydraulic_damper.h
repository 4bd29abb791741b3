#pragma once

#include <array>

#include "vehicles/laws/hydraulic_damper.h"
#include "vehicles/laws/spring_law.h"

namespace fourpost {

/// Hydraulic damper in series with a spring, its top mount: x_s is the mount's extension, x - x_s the damper's own. The
/// mount carries the force of oil and gas, mount(x_s) = F(P), so the pressures P determine x_s and
///   x_s' = (dF/dt) / mount'(x_s),   P' = damper's rates at x - x_s, x' - x_s'.
/// Friction acts between the ends of both. Below the mount it would lock the damper, and leave x_s' without an
/// equation, wherever it exceeds the mount's force. The mount must strictly increase, by at least its `stiffness`: no
/// knees, cubic >= 0.
struct MountedHydraulicDamper {
  HydraulicDamper damper;
  /// Zero stiffness: no mount; rates and energy are then those of the damper.
  SpringLaw mount;

  bool HasMount() const { return mount.stiffness > 0; }

  /// {P_r', P_c'} [Pa/s] at extension x and rate v of both together and pressures {P_r, P_c}.
  std::array<double, 2> PressureRates(double x, double v, const std::array<double, 2>& p) const;

  /// Energy stored in mount, oil and gas [J]; see HydraulicDamper::Energy.
  double Energy(double x, const std::array<double, 2>& p) const;

  /// x_s [m] at these pressures.
  double MountExtension(const std::array<double, 2>& p) const;

  bool operator==(const MountedHydraulicDamper&) const = default;
};

}  // namespace fourpost
