#include "analysis/signals/unfiltered.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::unfiltered_test {
namespace {

constexpr double kRate_Hz = 500;

/// A sweep from 1 to 25 Hz, faded in and out, of size 1.
std::vector<double> Sweep() {
  const double duration = 10;
  std::vector<double> sweep(static_cast<std::size_t>(kRate_Hz * duration));
  for (std::size_t k = 0; k < sweep.size(); ++k) {
    const double t = static_cast<double>(k) / kRate_Hz;
    const double fade = std::min({1.0, t / 0.5, (duration - t) / 0.5});
    const double smooth = fade * fade * (3 - 2 * fade);
    sweep[k] = smooth * std::sin(2 * std::numbers::pi * (t + 1.2 * t * t));
  }
  return sweep;
}

TEST(Unfiltered, GivesBackWhatTheFilterWasGiven) {
  const std::vector<double> given = Sweep();
  std::vector<double> filtered = given;
  const LowPass filter(4, 30, kRate_Hz);
  filter.Apply(filtered);
  const std::vector<double> back = Unfiltered(filtered, filter, 45 / kRate_Hz, 75 / kRate_Hz);
  double filtered_error = 0;
  double error = 0;
  for (std::size_t k = 0; k + 50 < given.size(); ++k) {
    filtered_error = std::max(filtered_error, std::abs(filtered[k] - given[k]));
    error = std::max(error, std::abs(back[k] - given[k]));
  }
  // What a fade over half a second leaves beyond 45 Hz.
  EXPECT_LT(error, 2e-3);
  EXPECT_GT(filtered_error, 1);
}

// A Butterworth filter has zeros at half the sampling rate, by which nothing may be divided.
TEST(Unfiltered, HoldsForRecordingsOfFourSamplesAPeriodOfTheCutoff) {
  constexpr double kSlow_Hz = 125;
  constexpr double kCutoff_Hz = 30;
  std::vector<double> given(2000);
  for (std::size_t k = 0; k < given.size(); ++k) {
    const double t = static_cast<double>(k) / kSlow_Hz;
    const double fade = std::min({1.0, t / 2, (16 - t) / 2});
    given[k] = fade * fade * (3 - 2 * fade) * std::sin(2 * std::numbers::pi * 20 * t);
  }
  std::vector<double> filtered = given;
  const LowPass filter(4, kCutoff_Hz, kSlow_Hz);
  filter.Apply(filtered);
  const std::vector<double> back = Unfiltered(filtered, filter, kCutoff_Hz / kSlow_Hz);
  double error = 0;
  for (std::size_t k = 0; k + 50 < given.size(); ++k) error = std::max(error, std::abs(back[k] - given[k]));
  // What a fade over two seconds leaves beyond 38 Hz.
  EXPECT_LT(error, 2e-3);
}

TEST(Unfiltered, KeepsAnOffset) {
  const LowPass filter(4, 30, kRate_Hz);
  for (const double sample : Unfiltered(std::vector<double>(2000, -0.012), filter, 0.1, 0.15))
    EXPECT_DOUBLE_EQ(sample, -0.012);
}

TEST(Unfiltered, RefusesWhatCannotBe) {
  const LowPass filter(4, 30, kRate_Hz);
  const std::vector<double> signal(10);
  EXPECT_THROW(Unfiltered({}, filter, 0.1, 0.2), std::invalid_argument);
  EXPECT_THROW(Unfiltered(signal, filter, 0.2, 0.1), std::invalid_argument);
  EXPECT_THROW(Unfiltered(signal, filter, 0.1, 0.6), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::unfiltered_test
