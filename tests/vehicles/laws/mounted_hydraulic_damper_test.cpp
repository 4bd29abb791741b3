#include "vehicles/laws/mounted_hydraulic_damper.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::mounted_hydraulic_damper_test {
namespace {

constexpr double kExtension = 0.01;  // m

MountedHydraulicDamper Mounted(double stiffness, double cubic = 0) {
  return {.damper = {.friction = 0}, .mount = {.stiffness = stiffness, .cubic = cubic, .knees = {}}};
}

/// Pressures about rest, in flow both ways and, the last, with vapour in the rebound chamber.
std::vector<std::array<double, 2>> Pressures() {
  return {{2.0e6, 2.0e6}, {2.6e6, 1.9e6}, {0.9e6, 2.3e6}, {5e3, 2.2e6}};
}

TEST(MountedHydraulicDamper, MountCarriesTheForceOfOilAndGas) {
  const MountedHydraulicDamper mounted = Mounted(400e3, 5e12);
  for (const auto& p : Pressures()) {
    const double force = mounted.damper.Force(0, p);
    // A few roundings, see IncreasingRoot.
    EXPECT_NEAR(mounted.mount.Force(mounted.MountExtension(p)), force, 1e-14 * std::abs(force));
  }
}

TEST(MountedHydraulicDamper, IsTheDamperAloneOnAStiffMount) {
  // The oil's stiffness K A^2 / V, 2 MN/m, over the mount's.
  constexpr double kYield = 1e-5;
  const MountedHydraulicDamper mounted = Mounted(1e12);
  for (const auto& p : Pressures()) {
    for (const double v : {-0.5, -0.01, 0.0, 0.3}) {
      const auto alone = mounted.damper.PressureRates(kExtension, v, p);
      const auto rates = mounted.PressureRates(kExtension, v, p);
      for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(rates[i], alone[i], kYield * std::abs(alone[i]));
    }
  }
}

TEST(MountedHydraulicDamper, DamperMovesByWhatTheMountLeaves) {
  const MountedHydraulicDamper mounted = Mounted(400e3, 5e12);
  constexpr double kStep = 1e-7;  // s
  for (const auto& p : Pressures()) {
    for (const double v : {-0.5, 0.3}) {
      const auto rates = mounted.PressureRates(kExtension, v, p);
      const auto extension_at = [&](double t) {
        return mounted.MountExtension({p[0] + t * rates[0], p[1] + t * rates[1]});
      };
      // Forward: backward the vapour's pressure would fall below its floor.
      const double mount_rate = (extension_at(kStep) - extension_at(0)) / kStep;
      ASSERT_GT(std::abs(mount_rate), 1e-3);
      const auto expected = mounted.damper.PressureRates(kExtension - extension_at(0), v - mount_rate, p);
      // Truncation of the forward difference: the step times the rate's own rate, some 1e3 / s.
      for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(rates[i], expected[i], 1e-3 * std::abs(expected[i]) + 1e3);
    }
  }
}

TEST(MountedHydraulicDamper, SoftensTheForceAndTakesPower) {
  // Third cycle of 2 Hz, peak 0.5 m/s, by Heun's method: energy lost per cycle and the force where the motion turns.
  const auto cycle = [](const MountedHydraulicDamper& mounted) {
    constexpr double kFrequency_Hz = 2;
    constexpr double kStep = 20e-6;
    const double omega = 2 * std::numbers::pi * kFrequency_Hz;
    const auto x = [&](double t) { return 0.5 / omega * std::sin(omega * t); };
    const auto v = [&](double t) { return 0.5 * std::cos(omega * t); };
    std::array<double, 2> p = mounted.damper.Rest();
    double work = 0;
    double most = 0;
    for (long k = 0; k < std::lround(3 / kFrequency_Hz / kStep); ++k) {
      const double t = static_cast<double>(k) * kStep;
      const auto first = mounted.PressureRates(x(t), v(t), p);
      const auto second =
          mounted.PressureRates(x(t + kStep), v(t + kStep), {p[0] + kStep * first[0], p[1] + kStep * first[1]});
      for (std::size_t i = 0; i < 2; ++i) p[i] += kStep / 2 * (first[i] + second[i]);
      if (t < 2 / kFrequency_Hz) continue;
      work += mounted.damper.Force(v(t), p) * v(t) * kStep;
      most = std::max(most, mounted.damper.Force(v(t), p));
    }
    return std::pair(work, most);
  };
  const auto [stiff_work, stiff_force] = cycle(Mounted(1e10));
  const auto [soft_work, soft_force] = cycle(Mounted(20e3));
  EXPECT_GT(soft_work, 0);
  EXPECT_LT(soft_work, stiff_work);
  EXPECT_LT(soft_force, stiff_force);
}

}  // namespace
}  // namespace fourpost::mounted_hydraulic_damper_test
