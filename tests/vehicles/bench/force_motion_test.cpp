#include "vehicles/bench/force_motion.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::force_motion_test {
namespace {

constexpr double kStep_s = 1e-3;
constexpr double kPi = std::numbers::pi;

struct Signals {
  std::vector<double> x;
  std::vector<double> v;
  std::vector<double> force;
};

/// Five cycles at 4 Hz and five at 10 Hz, both of 0.1 m/s; force of 1 kN s/m, `lead_deg` before the speed.
Signals TwoSines(double lead_deg) {
  Signals signals;
  for (const double frequency : {4.0, 10.0}) {
    const double w = 2 * kPi * frequency;
    const int count = static_cast<int>(std::lround(5 / frequency / kStep_s));
    for (int k = 0; k < count; ++k) {
      signals.x.push_back(0.1 / w * std::sin(w * k * kStep_s));
      signals.v.push_back(0.1 * std::cos(w * k * kStep_s));
      signals.force.push_back(100 * std::cos(w * k * kStep_s + lead_deg * kPi / 180));
    }
  }
  return signals;
}

// Central differences over 100 samples of a cycle err by 1e-3 of the rate.
TEST(ForceMotion, PhaseIsThatOfTheFastestCycles) {
  for (const double lead_deg : {-120.0, -30.0, 0.0, 20.0}) {
    const Signals signals = TwoSines(lead_deg);
    const std::optional<MotionPhase> fastest = PhaseOfFastest(signals.x, signals.force, kStep_s);
    ASSERT_TRUE(fastest);
    EXPECT_NEAR(fastest->frequency_Hz, 10, 0.1);
    EXPECT_NEAR(fastest->phase_deg, 90 + lead_deg, 1);
    EXPECT_NEAR(fastest->Lead_s(), lead_deg / 360 / 10, 0.3e-3);
  }
}

TEST(ForceMotion, HasNoPhaseWithoutACycle) {
  const std::vector<double> x = {0, 1, 2, 3};
  EXPECT_FALSE(PhaseOfFastest(x, x, kStep_s));
}

TEST(ForceMotion, ShareIsThatOfTheLaws) {
  Signals signals = TwoSines(0);
  EXPECT_NEAR(ShareOfMotion(signals.x, signals.v, signals.force), 1, 1e-12);
  // Friction and bilinear rates, too.
  for (std::size_t k = 0; k < signals.v.size(); ++k)
    signals.force[k] = 300 * std::abs(signals.v[k]) + (signals.v[k] > 0 ? 20 : -20) + 7;
  EXPECT_NEAR(ShareOfMotion(signals.x, signals.v, signals.force), 1, 1e-3);
  // Of another frequency.
  for (std::size_t k = 0; k < signals.v.size(); ++k)
    signals.force[k] = std::sin(0.05 * static_cast<double>(k * k % 1000));
  EXPECT_LT(ShareOfMotion(signals.x, signals.v, signals.force), 0.1);
  signals.force.assign(signals.force.size(), 3);
  EXPECT_EQ(ShareOfMotion(signals.x, signals.v, signals.force), 0);
}

}  // namespace
}  // namespace fourpost::force_motion_test
