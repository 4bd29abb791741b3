#include "vehicles/laws/mounted_hydraulic_damper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vehicles/laws/increasing_root.h"

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

std::array<double, 2> MountedHydraulicDamper::PressureRates(double x, double v, const std::array<double, 2>& p) const {
  const double extension = MountExtension(p);
  const double stiffness = mount.Slope(extension);
  // How fast the mount stretches when the damper's own rate is w: it rises with w, oil being pressed harder.
  const auto mount_rate = [&](double w) {
    const std::array<double, 2> rates = damper.PressureRates(x - extension, w, p);
    return (damper.annulus_area * rates[0] - damper.piston_area * rates[1]) / stiffness;
  };
  // Straight in w but for the floor of cavitation, so that a chord is the slope.
  const auto both = [&](double w) {
    const double rate = mount_rate(w);
    return std::pair(w + rate, 1 + mount_rate(w + 1) - rate);
  };
  // Since the mount's rate rises with w, this far from v the sum is on the other side.
  const double other = v - mount_rate(v);
  const double own = IncreasingRoot(both, v, std::min(v, other), std::max(v, other), v);
  return damper.PressureRates(x - extension, own, p);
}

}  // namespace fourpost
