#include "identify/experiments/four_post/response_discrepancy.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace fourpost::response_discrepancy_test {
namespace {

using Complex = std::complex<double>;

/// One channel at these frequencies, the model of gain 1 without a phase.
struct Case {
  MeasuredRun run;
  FrequencyResponse modelled;
};

Case Of(const std::vector<double>& frequencies, const std::vector<Complex>& measured, double scatter) {
  Case one;
  one.run.excitation.frequency_Hz = frequencies;
  const std::vector<double> sd(frequencies.size(), scatter);
  one.run.channels.push_back(
      {.sensor = 0, .name = "a", .unit = "m", .response = measured, .radial_sd = sd, .tangential_sd = sd});
  one.modelled.frequency_Hz = frequencies;
  one.modelled.channels.push_back({.name = "a", .unit = "m", .response = std::vector<Complex>(frequencies.size(), 1)});
  return one;
}

// The level of a gain of 1 that is the loudest itself.
const double kLevel = std::hypot(1, 0.03);

// 20 errors of 1 % to 20 % along the phasor, half of that across: of so few, the largest.
TEST(ResponseDiscrepancy, IsWhat95Of100StayBelow) {
  std::vector<double> frequencies;
  std::vector<Complex> measured;
  for (int i = 1; i <= 20; ++i) {
    frequencies.push_back(2 + 0.05 * i);
    measured.emplace_back(1 + 0.01 * i, -0.005 * i);
  }
  const Case one = Of(frequencies, measured, 0);
  const auto all = ResponseDiscrepancies({one.run}, {one.modelled});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].lower_Hz, 2);
  EXPECT_NEAR(all[0].radial, 0.2 / kLevel, 1e-12);
  EXPECT_NEAR(all[0].tangential, 0.1 / kLevel, 1e-12);
}

TEST(ResponseDiscrepancy, LeavesOutTheScatterOfTheRepeats) {
  const Case one = Of({2, 3}, {1.1, 0.9}, 0.02);
  const double missed = std::sqrt(0.1 * 0.1 - std::pow(1.959963984540054 * 0.02, 2));
  EXPECT_NEAR(ResponseDiscrepancies({one.run}, {one.modelled})[0].radial, missed / kLevel, 1e-12);
  const Case noisy = Of({2, 3}, {1.1, 0.9}, 0.2);
  EXPECT_EQ(ResponseDiscrepancies({noisy.run}, {noisy.modelled})[0].radial, 0);
}

TEST(ResponseDiscrepancy, IsThatOfTheNearestOctave) {
  const Case one = Of({1, 9}, {1.1, 1.3}, 0);
  const auto all = ResponseDiscrepancies({one.run}, {one.modelled});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NEAR(DiscrepancyAt(all, "a", 0.6).radial, 0.1 / kLevel, 1e-12);
  EXPECT_NEAR(DiscrepancyAt(all, "a", 2.1).radial, 0.1 / kLevel, 1e-12);
  EXPECT_NEAR(DiscrepancyAt(all, "a", 20).radial, 0.3 / kLevel, 1e-12);
  EXPECT_NEAR(DiscrepancyAt(all, "another", 20).radial, 0.3 / kLevel, 1e-12);
}

TEST(ResponseDiscrepancy, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const Case one = Of({1, 9}, {1.1, 1.3}, 0);
  const auto all = ResponseDiscrepancies({one.run}, {one.modelled});
  folder.Write("result.json", nlohmann::ordered_json{{"discrepancy", DiscrepancyJson(all)}}.dump());
  const auto read = ReadDiscrepancies(folder.path() / "result.json");
  ASSERT_EQ(read.size(), all.size());
  EXPECT_EQ(read[1].radial, all[1].radial);
  EXPECT_EQ(read[1].channel, "a");
  EXPECT_EQ(read[1].lower_Hz, 8);
}

}  // namespace
}  // namespace fourpost::response_discrepancy_test
