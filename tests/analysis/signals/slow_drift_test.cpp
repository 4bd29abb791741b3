#include "analysis/signals/slow_drift.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::slow_drift_test {
namespace {

constexpr double kRate = 200;
constexpr double kDuration_s = 60;

using Signal = std::vector<double>;

Signal Sampled(const std::function<double(double)>& at) {
  Signal signal;
  for (int k = 0; k < kDuration_s * kRate; ++k) signal.push_back(at(k / kRate));
  return signal;
}

double Swing(double cycles) { return std::sin(2 * std::numbers::pi * cycles); }

/// Of many sines from the lowest frequency to 10 Hz, with a deviation of about 1.
Signal RandomMotion(double lowest_Hz, RandomStream& random) {
  constexpr int kSines = 60;
  std::vector<double> phases;
  for (int i = 0; i < kSines; ++i) phases.push_back(random.Uniform());
  return Sampled([&](double t) {
    double sum = 0;
    for (int i = 0; i < kSines; ++i)
      sum += Swing(lowest_Hz * std::pow(10 / lowest_Hz, (i + 0.37) / kSines) * t + phases[static_cast<std::size_t>(i)]);
    return sum * std::sqrt(2.0 / kSines);
  });
}

/// A force that is stronger on one side, as a damper's.
double OneSided(double speed, double share) { return speed + share * std::abs(speed); }

Signal WithNoise(Signal signal, double sd, RandomStream& random) {
  for (double& value : signal) value += sd * random.Normal();
  return signal;
}

double PeakOf(const Signal& signal) {
  double peak = 0;
  for (const double value : signal) peak = std::max(peak, std::abs(value));
  return peak;
}

/// Rises by `size` to the end, more slowly towards it.
Signal Warming(Signal signal, double size) {
  for (std::size_t k = 0; k < signal.size(); ++k) {
    const double time = static_cast<double>(k) / static_cast<double>(signal.size());
    signal[k] += size * (1 - std::exp(-2 * time)) / (1 - std::exp(-2));
  }
  return signal;
}

// Of the peak, as of a load cell that warms up; a line through what curves is off by a tenth of it.
TEST(SlowDrift, IsFoundOfRandomMotionAndOfASine) {
  RandomStream random(5, "drift");
  for (const double share : {-0.05, 0.02, 0.05}) {
    const Signal sine = WithNoise(Sampled([](double t) { return OneSided(Swing(1.3 * t), 0.4); }), 0.01, random);
    const double of_sine = share * PeakOf(sine);
    ASSERT_TRUE(SlowDrift(Warming(sine, of_sine))) << share;
    EXPECT_NEAR(*SlowDrift(Warming(sine, of_sine)) / of_sine, 1, 0.15);
    const Signal motion = RandomMotion(0.5, random);
    const double of_motion = 2 * share * PeakOf(motion);
    ASSERT_TRUE(SlowDrift(Warming(motion, of_motion))) << share;
    EXPECT_NEAR(*SlowDrift(Warming(motion, of_motion)) / of_motion, 1, 0.15);
  }
}

// Sweeps up and down, steps, fades of a damper that warms up, random motion down to a tenth of a hertz, alone and as
// the force of a damper whose sides differ.
TEST(SlowDrift, IsNotSeenInWhatDoesNotDrift) {
  RandomStream random(9, "clean");
  const auto between = [&](double least, double most) { return least + (most - least) * random.Uniform(); };
  for (int i = 0; i < 40; ++i) {
    const double f = between(0.3, 4);
    const double share = between(-0.4, 0.4);
    const double noise = between(0.001, 0.05);
    const double lowest = between(0.1, 0.5);
    const double octaves = std::log(15 / lowest);
    const auto sweep = [&](double t) {
      return Swing(lowest * kDuration_s / octaves * (std::exp(octaves * t / kDuration_s) - 1));
    };
    const auto fade = [&](double t) { return (1 - 0.3 * (1 - std::exp(-2 * t / kDuration_s))) * Swing(f * t); };
    const auto step = [&](double t) { return Swing(lowest * std::pow(1.5, std::floor(t / 6)) * t); };
    const Signal clean[] = {
        Sampled([&](double t) { return OneSided(sweep(t), share); }),
        Sampled([&](double t) { return OneSided(sweep(kDuration_s - t), share); }),
        Sampled([&](double t) { return OneSided(fade(t), share); }),
        Sampled([&](double t) { return OneSided(step(t), share); }),
        Sampled([&](double t) { return OneSided(step(kDuration_s - t), share); }),
        Sampled([&](double t) { return OneSided(Swing(f * t), share); }),
        RandomMotion(lowest, random),
    };
    for (std::size_t kind = 0; kind < std::size(clean); ++kind)
      EXPECT_FALSE(SlowDrift(WithNoise(clean[kind], noise, random))) << "kind " << kind << " of " << i;
  }
}

// Nothing to tell of few samples, of a level that jumps, of none that changes and of a gap.
TEST(SlowDrift, NeedsSamplesThatRiseSteadily) {
  EXPECT_FALSE(SlowDrift(Signal(100, 1)));
  EXPECT_FALSE(SlowDrift(Signal(10000, 1)));
  RandomStream random(3, "jump");
  const Signal sine = WithNoise(Sampled([](double t) { return Swing(2 * t); }), 0.01, random);
  Signal jumps = sine;
  for (std::size_t k = jumps.size() / 2; k < jumps.size(); ++k) jumps[k] += 0.2;
  EXPECT_FALSE(SlowDrift(jumps));
  Signal holed = Warming(sine, 0.1);
  EXPECT_TRUE(SlowDrift(holed));
  holed[5000] = std::nan("");
  EXPECT_FALSE(SlowDrift(holed));
}

}  // namespace
}  // namespace fourpost::slow_drift_test
