#include "vehicles/laws/mounted_hydraulic_damper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numerics/increasing_root.h"

namespace fourpost {

double MountedHydraulicDamper::MountExtension(const std::array<double, 2>& p) const {
  const double force = damper.Force(0, p);
  const double most = std::abs(force) / mount.stiffness;
  const auto law = [this](double x) { return std::pair(mount.Force(x), mount.Slope(x)); };
  return IncreasingRoot(law, force, -most, most, force / mount.stiffness);
}

double MountedHydraulicDamper::Energy(double x, const std::array<double, 2>& p) const {
  const double extension = MountExtension(p);
  return damper.Energy(x - extension, p) + mount.Energy(extension);
}

// The damper's pressures, and with them its force, change by a constant and a share of its own rate w, which rises with
// w: oil is pressed harder.
std::array<double, 2> MountedHydraulicDamper::PressureRates(double x, double v, const std::array<double, 2>& p) const {
  const double extension = MountExtension(p);
  const double stiffness = mount.Slope(extension);
  const auto mount_rate = [&](double w) {
    const std::array<double, 2> rates = damper.PressureRates(x - extension, w, p);
    const auto force_rate = [&](std::size_t i) { return p[i] < damper.cavitation_pressure ? 0 : rates[i]; };
    return (damper.annulus_area * force_rate(0) - damper.piston_area * force_rate(1)) / stiffness;
  };
  const double standing = mount_rate(0);
  const double own = (v - standing) / (1 + mount_rate(1) - standing);
  return damper.PressureRates(x - extension, own, p);
}

}  // namespace fourpost
