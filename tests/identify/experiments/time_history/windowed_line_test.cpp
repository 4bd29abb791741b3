#include "identify/experiments/time_history/windowed_line.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::windowed_line_test {
namespace {

using Complex = std::complex<double>;

constexpr double kRate_Hz = 100;
constexpr std::size_t kSamples = 1000;

/// A displacement of many sines that do not fit the window, and its derivatives.
struct Motion {
  std::vector<double> derivative[3];
};

Motion Moved() {
  RandomStream random(1, "motion");
  Motion motion;
  for (std::vector<double>& values : motion.derivative) values.resize(kSamples);
  for (int tone = 0; tone < 40; ++tone) {
    const double omega = 2 * std::numbers::pi * (0.31 + 0.173 * tone);
    const double phase = 10 * random.Normal();
    const double size = random.Normal() / (1 + tone);
    for (std::size_t k = 0; k < kSamples; ++k) {
      const double angle = omega * static_cast<double>(k) / kRate_Hz + phase;
      motion.derivative[0][k] += size * std::sin(angle);
      motion.derivative[1][k] += size * omega * std::cos(angle);
      motion.derivative[2][k] -= size * omega * omega * std::sin(angle);
    }
  }
  return motion;
}

// The sum stands for an integral: its error is that of the window's ends, of second order in a sample over the window.
TEST(WindowedLine, OfASignalsDerivativeIsThatOfTheDerivative) {
  const Motion motion = Moved();
  for (const double frequency_Hz : {0.9, 2.345, 6.0}) {
    const WindowedLine line(kSamples, kRate_Hz, frequency_Hz);
    const Complex acceleration = line.Of(motion.derivative[2], 0);
    for (const int order : {1, 2}) {
      const Complex other = line.Of(motion.derivative[2 - order], order);
      EXPECT_LT(std::abs(other - acceleration), 1e-4 * std::abs(acceleration)) << frequency_Hz << ' ' << order;
    }
    // Without the window's own derivatives it would be off by some per cent.
    const double square = std::pow(2 * std::numbers::pi * frequency_Hz, 2);
    EXPECT_GT(std::abs(-square * line.Of(motion.derivative[0], 0) - acceleration), 1e-3 * std::abs(acceleration));
  }
}

TEST(WindowedLine, HasTheAmplitudeOfASine) {
  std::vector<double> sine(kSamples);
  for (std::size_t k = 0; k < kSamples; ++k)
    sine[k] = 3 * std::cos(2 * std::numbers::pi * 5 * static_cast<double>(k) / kRate_Hz);
  // Hann's window has zeros at all other whole cycles of the window.
  EXPECT_NEAR(std::abs(WindowedLine(kSamples, kRate_Hz, 5).Of(sine, 0)), 3, 1e-9);
}

TEST(WindowedLine, KnowsWhatNoiseBrings) {
  const WindowedLine line(kSamples, kRate_Hz, 5);
  RandomStream random(2, "noise");
  double square = 0;
  constexpr int kDraws = 2000;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<double> noise(kSamples);
    for (double& value : noise) value = 0.7 * random.Normal();
    square += std::pow(line.Of(noise, 0).real(), 2) / kDraws;
  }
  // 2000 squares have a mean good to 3 %, its root to 1.6 %: three of them.
  EXPECT_NEAR(std::sqrt(square) / line.NoiseSd(0.7), 1, 0.05);
}

}  // namespace
}  // namespace fourpost::windowed_line_test
