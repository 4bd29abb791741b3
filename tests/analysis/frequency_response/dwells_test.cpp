#include "analysis/frequency_response/dwells.h"

#include <gtest/gtest.h>

#include "analysis/frequency_response/excitation_kind.h"
#include "tests/analysis/frequency_response/known_system.h"

namespace fourpost {
namespace {

constexpr double kRate = 500;

std::vector<Dwell> DwellsOf(const std::vector<double>& signal) { return FindDwells(TrackTone(signal)); }

ExcitationKind KindOf(const std::vector<double>& signal) {
  const std::vector<TonePoint> track = TrackTone(signal);
  return KindOf(signal, track, FindDwells(track));
}

TEST(ToneTrack, FollowsAToneWithinItsWindow) {
  std::vector<double> signal;
  for (int k = 0; k < 5000; ++k) signal.push_back(3 + 2 * std::cos(0.4 + 2 * std::numbers::pi * 0.013 * k));
  for (const TonePoint& point : TrackTone(signal)) {
    // Next to the ends there is no window of three cycles.
    if (point.time < 2 / 0.013 || point.time > 5000 - 2 / 0.013) continue;
    // Windows of a quarter octave's step see the tone off their middle, and a sum over samples is no integral.
    EXPECT_NEAR(point.cycles_per_sample, 0.013, 1e-5);
    EXPECT_NEAR(std::remainder(point.phase_rad - 0.4 - 2 * std::numbers::pi * 0.013 * point.time, 2 * std::numbers::pi),
                0, 0.01);
    EXPECT_NEAR(point.amplitude, 2, 0.25);
    EXPECT_GT(point.share, 0.9);
  }
}

TEST(ToneTrack, IsEmptyOfNothing) {
  EXPECT_TRUE(TrackTone({}).empty());
  EXPECT_TRUE(TrackTone(std::vector<double>(1000, 2.0)).empty());
}

/// 64 steps of 7 % in frequency over two decades of amplitude, with noise that hides the last of them by half.
TEST(Dwells, AreFoundWithFrequencyAndEnds) {
  const std::vector<double> frequencies = LogFrequencies(0.5, 30, 64);
  for (const double noise : {0.0, 0.001, 0.01}) {
    const std::vector<Dwell> dwells = DwellsOf(Noisy(SteppedSine(frequencies, 10, kRate), noise, 0.02, 1));
    ASSERT_EQ(dwells.size(), frequencies.size());
    double start = 2 * kRate;
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
      const double cycle = kRate / frequencies[k];
      EXPECT_NEAR(dwells[k].cycles_per_sample * cycle, 1, 0.01);
      EXPECT_NEAR(dwells[k].start, start, 2 * cycle);
      start += std::floor(std::max(10 * cycle, 4 * kRate));
      EXPECT_NEAR(dwells[k].end, start, 2 * cycle);
    }
  }
}

TEST(Dwells, OfOneFrequencyPartWhereTheAmplitudeSteps) {
  std::vector<double> signal;
  for (int k = 0; k < 20000; ++k)
    signal.push_back((k < 10000 ? 1 : 0.5) * std::sin(2 * std::numbers::pi * 2 / kRate * k));
  const std::vector<Dwell> dwells = DwellsOf(signal);
  ASSERT_EQ(dwells.size(), 2U);
  EXPECT_NEAR(dwells[0].amplitude, 1, 0.05);
  EXPECT_NEAR(dwells[1].amplitude, 0.5, 0.03);
}

TEST(ExcitationKind, IsFoundInTheMotion) {
  EXPECT_EQ(KindOf(Noisy(SteppedSine(LogFrequencies(0.5, 30, 40), 12, kRate), 0.01, 0, 1)), ExcitationKind::kStepped);
  for (const double duration_s : {40.0, 120.0, 600.0})
    EXPECT_EQ(KindOf(Noisy(LogSweep(duration_s, kRate), 0.01, 0, 1)), ExcitationKind::kSweep) << duration_s;
  EXPECT_EQ(KindOf(RandomMotion(120, kRate, 1)), ExcitationKind::kRandom);
  std::vector<double> period = RandomMotion(10, kRate, 2);
  std::vector<double> repeated;
  for (int k = 0; k < 6; ++k) repeated.insert(repeated.end(), period.begin(), period.end());
  EXPECT_EQ(KindOf(Noisy(repeated, 0.01, 0, 1)), ExcitationKind::kMultisine);
}

TEST(ExcitationKind, OfOneLongSineIsStepped) {
  std::vector<double> signal;
  for (int k = 0; k < 20000; ++k) signal.push_back(std::sin(2 * std::numbers::pi * 2 / kRate * k));
  EXPECT_EQ(KindOf(signal), ExcitationKind::kStepped);
}

}  // namespace
}  // namespace fourpost
