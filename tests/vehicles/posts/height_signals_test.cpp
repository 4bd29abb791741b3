#include "vehicles/posts/height_signals.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/vehicles/posts/consistent_motion.h"
#include "vehicles/posts/post_motions.h"

namespace fourpost::height_signals_test {
namespace {

using std::numbers::pi;

SweptSine Sweep() { return {.first_Hz = 0.5, .last_Hz = 30, .duration_s = 20, .amplitude_m = 0.01, .top_speed = 0.06}; }

/// Frequency between the two rising zeros of a signal about t.
double FrequencyAbout(const UniformSpline& signal, double t) {
  const auto next_zero = [&](double from) {
    double before = from;
    while (!(signal.At(before).value < 0 && signal.At(before + 1e-5).value >= 0)) before += 1e-5;
    return before;
  };
  const double first = next_zero(t);
  return 1 / (next_zero(first + 2e-5) - first);
}

TEST(SteppedSine, DwellsWithItsAmplitudesFromRestToRest) {
  const SteppedSine sines{.dwells = {{1, 0.01, 5}, {4, 0.002, 3}}};
  EXPECT_EQ(sines.Duration(), 8);
  const UniformSpline signal = sines.Signal();
  EXPECT_NEAR(signal.end(), 8, 1e-12);
  // In the middle of the dwells, a quarter of a cycle after a rising zero. Splines of 20 samples a cycle err by 3e-5.
  EXPECT_NEAR(signal.At(2.25).value, 0.01, 1e-6);
  EXPECT_NEAR(signal.At(5 + 1.0625).value, 0.002, 1e-6);
  for (const double t : {0.0, 5.0, 8.0}) {
    EXPECT_NEAR(signal.At(t).value, 0, 2e-5) << t;
    EXPECT_NEAR(signal.At(t).slope, 0, 1e-3) << t;
  }
}

TEST(SteppedSine, RefusesDwellsThatAreNone) {
  EXPECT_THROW(SteppedSine{}.Signal(), std::invalid_argument);
  EXPECT_THROW((SteppedSine{.dwells = {{1, 0.01, 1}}}.Signal()), std::invalid_argument);
  EXPECT_THROW((SteppedSine{.dwells = {{1, 0, 5}}}.Signal()), std::invalid_argument);
}

TEST(SweptSine, GoesThroughItsFrequenciesEvenlyInOctaves) {
  const UniformSpline signal = Sweep().Signal();
  // Within a cycle the frequency rises by ln(60) / 20 s of itself times the period.
  for (const double t : {5.0, 10.0, 15.0}) {
    const double expected = 0.5 * std::pow(60, t / 20);
    EXPECT_NEAR(FrequencyAbout(signal, t) / expected, 1, 0.5 / expected);
  }
}

TEST(SweptSine, GoesThroughItsFrequenciesEvenlyInTime) {
  SweptSine sweep = Sweep();
  sweep.logarithmic = false;
  EXPECT_NEAR(FrequencyAbout(sweep.Signal(), 10), 15.25, 0.2);
}

TEST(SweptSine, KeepsItsAmplitudeAndThenItsPeakVelocity) {
  const UniformSpline signal = Sweep().Signal();
  double early = 0;
  double late = 0;
  double speed = 0;
  for (double t = 0; t < 20; t += 1e-3) {
    const UniformSpline::Point now = signal.At(t);
    // Below 0.06 / (2 pi 0.01) = 0.95 Hz, at 3.1 s.
    if (t < 3) early = std::max(early, std::abs(now.value));
    if (t > 19) late = std::max(late, std::abs(now.value));
    speed = std::max(speed, std::abs(now.slope));
  }
  // A sample of 1 ms next to a peak.
  EXPECT_NEAR(early, 0.01, 2e-5);
  // At 19 s the sweep is at 30 x 60^(-1/20) = 24.4 Hz.
  EXPECT_NEAR(late, 0.06 / (2 * pi * 24.4), 0.05 * late);
  EXPECT_NEAR(speed, 0.06, 0.002);
}

TEST(SweptSine, MayStandOrFall) {
  const SweptSine sine{.first_Hz = 3, .last_Hz = 3, .duration_s = 5, .amplitude_m = 0.01};
  EXPECT_NEAR(FrequencyAbout(sine.Signal(), 2), 3, 1e-3);
  const SweptSine falling{.first_Hz = 20, .last_Hz = 1, .duration_s = 10, .amplitude_m = 0.01};
  EXPECT_NEAR(FrequencyAbout(falling.Signal(), 5), std::sqrt(20), 0.4);
}

TEST(SweptSine, RefusesWhatCannotBe) {
  EXPECT_THROW((SweptSine{.first_Hz = 0, .last_Hz = 1, .duration_s = 1, .amplitude_m = 1}.Signal()),
               std::invalid_argument);
  EXPECT_THROW((SweptSine{.first_Hz = 1, .last_Hz = 1, .duration_s = 1, .amplitude_m = NAN}.Signal()),
               std::invalid_argument);
}

TEST(SmoothStep, RisesInItsTimeAndStays) {
  const UniformSpline signal = SmoothStep{.height_m = 0.02, .rise_s = 0.05, .start_s = 0.5}.Signal();
  EXPECT_EQ(signal.At(0.4).value, 0);
  EXPECT_NEAR(signal.At(0.525).value, 0.01, 1e-9);
  // 1.875 height / rise; the spline errs by the square of a 256th.
  EXPECT_NEAR(signal.At(0.525).slope, 1.875 * 0.02 / 0.05, 1e-4);
  EXPECT_EQ(signal.At(0.6).value, 0.02);
  EXPECT_EQ(signal.At(0.6).slope, 0);
  EXPECT_THROW((SmoothStep{.height_m = 0.02, .rise_s = 0, .start_s = 1}.Signal()), std::invalid_argument);
}

RandomHeights Rough() { return {.rms_m = 0.004, .lower_Hz = 0.5, .upper_Hz = 20, .duration_s = 60, .seed = 5}; }

TEST(RandomHeights, HaveTheirRootMeanSquareAndWhiteVelocity) {
  const UniformSpline signal = Rough().Signal();
  double heights = 0;
  double velocities = 0;
  int count = 0;
  for (double t = 1; t < 59; t += 2e-3, ++count) {
    heights += std::pow(signal.At(t).value, 2);
    velocities += std::pow(signal.At(t).slope, 2);
  }
  // 58 s of a signal whose power lies about 0.5 Hz: some thirty independent values.
  EXPECT_NEAR(std::sqrt(heights / count) / 0.004, 1, 0.15);
  // Of a density c / f^2 the heights have c (1/0.5 - 1/20), the velocities (2 pi)^2 c (20 - 0.5).
  EXPECT_NEAR(std::sqrt(velocities / count) / (0.004 * 2 * pi * std::sqrt(19.5 / 1.95)), 1, 0.05);
}

TEST(RandomHeights, AreThoseOfTheirSeed) {
  RandomHeights other = Rough();
  other.seed = 6;
  EXPECT_EQ(Rough().Signal().At(10).value, Rough().Signal().At(10).value);
  EXPECT_NE(Rough().Signal().At(10).value, other.Signal().At(10).value);
  EXPECT_THROW((RandomHeights{.rms_m = 1, .lower_Hz = 2, .upper_Hz = 1, .duration_s = 1}.Signal()),
               std::invalid_argument);
}

TEST(HeightSignals, HaveVelocitiesAndAccelerationsOfTheirHeights) {
  const std::vector<double> one = {1};
  ExpectConsistent(FollowPattern(Sweep().Signal(), one), 1, 0, 20, 1 / (64.0 * 30));
  ExpectConsistent(FollowPattern(SmoothStep{.height_m = 0.02, .rise_s = 0.05, .start_s = 0.5}.Signal(), one), 1, 0.5,
                   0.55, 0.05 / 256);
  ExpectConsistent(FollowPattern(Rough().Signal(), one), 1, 0, 60, 1 / (64.0 * 20));
}

}  // namespace
}  // namespace fourpost::height_signals_test
