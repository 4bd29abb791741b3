#include "analysis/frequency_response/dwells.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "analysis/frequency_response/excitation_kind.h"
#include "analysis/frequency_response/stated_dwells.h"
#include "tests/analysis/frequency_response/known_system.h"

namespace fourpost::dwells_test {
namespace {

constexpr double kRate = 500;

std::vector<Dwell> DwellsOf(const std::vector<double>& signal) { return FindDwells(signal, TrackTone(signal)); }

ExcitationKind KindOf(const std::vector<double>& signal) {
  const std::vector<TonePoint> track = TrackTone(signal);
  return KindOf(signal, track, FindDwells(signal, track));
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

struct ShortDwells {
  std::vector<double> signal;
  std::vector<double> frequencies_Hz;
  /// Samples; the end is that of the dwell, before the pause.
  std::vector<double> start;
  std::vector<double> end;
};

/// Dwells of as many cycles, with harmonics of 3 % each, noise of a share of all, and pauses.
ShortDwells MakeShortDwells(const std::vector<double>& frequencies_Hz, double cycles, double pause_s,
                            std::uint64_t seed, double noise = 0.01) {
  constexpr double kHarmonic = 0.03;
  ShortDwells made{.signal = std::vector<double>(static_cast<std::size_t>(2 * kRate), 0.0),
                   .frequencies_Hz = frequencies_Hz};
  double phase = 0;
  for (const double frequency : frequencies_Hz) {
    made.start.push_back(static_cast<double>(made.signal.size()));
    const double samples = std::round(cycles / frequency * kRate);
    for (double k = 0; k < samples; ++k) {
      phase += 2 * std::numbers::pi * frequency / kRate;
      made.signal.push_back(RigAmplitude(frequency) * (std::sin(phase) + kHarmonic * std::sin(2 * phase + 0.3) +
                                                       kHarmonic * std::sin(3 * phase + 1)));
    }
    made.end.push_back(static_cast<double>(made.signal.size()));
    made.signal.resize(made.signal.size() + static_cast<std::size_t>(pause_s * kRate), 0.0);
  }
  made.signal = Noisy(std::move(made.signal), noise, 0.02, seed);
  return made;
}

std::vector<double> InSteps(double ratio, double last_Hz) {
  std::vector<double> frequencies;
  for (double frequency = 0.5; frequency < last_Hz; frequency *= ratio) frequencies.push_back(frequency);
  return frequencies;
}

/// How many of the dwells that were made are among those found, each by one within a cycle of its ends.
std::size_t CountFound(const ShortDwells& made, const std::vector<Dwell>& found) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < made.start.size(); ++k) {
    const double cycle = kRate / made.frequencies_Hz[k];
    count += static_cast<std::size_t>(std::count_if(found.begin(), found.end(), [&](const Dwell& dwell) {
      return std::abs(dwell.cycles_per_sample * cycle - 1) < 0.015 &&
             std::abs(dwell.start - made.start[k]) < 1.3 * cycle && std::abs(dwell.end - made.end[k]) < 1.3 * cycle;
    }));
  }
  return count;
}

// At most one in fifty may be missed, and one in a hundred be noise: steps of 5 % turn the phase of four cycles by 70
// degrees.
TEST(Dwells, OfFourCyclesAreFound) {
  for (const double pause_s : {0.0, 1.0})
    for (const double ratio : {1.05, 1.1})
      for (const double cycles : {4.0, 5.0, 6.0, 8.0}) {
        std::size_t all = 0;
        std::size_t found = 0;
        std::size_t right = 0;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
          const ShortDwells made = MakeShortDwells(InSteps(ratio, 8), cycles, pause_s, seed);
          const std::vector<Dwell> dwells = DwellsOf(made.signal);
          all += made.start.size();
          found += dwells.size();
          right += CountFound(made, dwells);
          EXPECT_EQ(KindOf(made.signal), ExcitationKind::kStepped);
        }
        EXPECT_GE(static_cast<double>(right), 0.98 * static_cast<double>(all))
            << cycles << ' ' << ratio << ' ' << pause_s;
        EXPECT_LE(static_cast<double>(found - right), 0.01 * static_cast<double>(all)) << cycles << ' ' << ratio;
      }
}

std::vector<double> FromTo(double first_Hz, double ratio, int count) {
  std::vector<double> frequencies;
  for (int k = 0; k < count; ++k) frequencies.push_back(first_Hz * std::pow(ratio, k));
  return frequencies;
}

// Windows of two cycles see a large step twice, once from each side, so that little is left of four cycles.
TEST(Dwells, OfFourCyclesAreFoundBesideLargeSteps) {
  // A tenth of the smallest amplitudes.
  constexpr double kNoise = 0.005;
  const std::vector<double> irregular = {1, 2, 4, 8, 12, 16, 20};
  std::vector<std::vector<double>> sets = {
      irregular, {10, 15, 20, 25, 30}, {2, 3, 4, 5, 6, 7, 8}, FromTo(1, std::cbrt(2.0), 14), FromTo(0.5, 2, 6)};
  for (std::size_t k = 0; k < 5; ++k) {
    sets.push_back(sets[k]);
    std::reverse(sets.back().begin(), sets.back().end());
  }
  for (const double cycles : {4.0, 5.0, 6.0})
    for (const double pause_s : {0.0, 1.0}) {
      std::size_t all = 0;
      std::size_t right = 0;
      std::size_t stated = 0;
      std::size_t found = 0;
      for (const std::vector<double>& frequencies_Hz : sets) {
        const ShortDwells made = MakeShortDwells(frequencies_Hz, cycles, pause_s, 1, kNoise);
        const std::vector<TonePoint> track = TrackTone(made.signal);
        const std::vector<Dwell> dwells = FindDwells(made.signal, track);
        std::vector<double> known = frequencies_Hz;
        std::sort(known.begin(), known.end());
        for (double& frequency : known) frequency /= kRate;
        all += frequencies_Hz.size();
        found += dwells.size();
        right += CountFound(made, dwells);
        // To know the frequencies must not cost a dwell.
        stated += CountFound(made, DwellsOfFrequencies(made.signal, track, dwells, known));
      }
      EXPECT_GE(static_cast<double>(right), 0.98 * static_cast<double>(all)) << cycles << ' ' << pause_s;
      EXPECT_GE(stated, right) << cycles << ' ' << pause_s;
      EXPECT_LE(found, all) << cycles << ' ' << pause_s;
    }
}

// Where ten cycles and three take turns, next to all of the short ones are found.
TEST(Dwells, OfThreeCyclesAreFoundBetweenOthers) {
  ShortDwells made{.signal = std::vector<double>(static_cast<std::size_t>(2 * kRate), 0.0)};
  double phase = 0;
  for (int k = 0; k < 12; ++k) {
    made.frequencies_Hz.push_back(1.5 * std::pow(1.27, k));
    made.start.push_back(static_cast<double>(made.signal.size()));
    for (double n = std::round((k % 2 == 0 ? 10 : 3) / made.frequencies_Hz.back() * kRate); n > 0; --n)
      made.signal.push_back(2e-3 * std::sin(phase += 2 * std::numbers::pi * made.frequencies_Hz.back() / kRate));
    made.end.push_back(static_cast<double>(made.signal.size()));
  }
  made.signal = Noisy(std::move(made.signal), 0.005, 0.02, 1);
  const std::vector<Dwell> dwells = DwellsOf(made.signal);
  EXPECT_GE(CountFound(made, dwells), 11U);
  EXPECT_LE(dwells.size(), 12U);
}

// Ends are good to a quarter of a cycle where the next frequency or amplitude is another by a tenth.
TEST(Dwells, EndWhereTheSineDoes) {
  for (const double pause_s : {0.0, 1.0}) {
    const ShortDwells made = MakeShortDwells(FromTo(0.5, 1.2, 16), 8, pause_s, 1);
    const std::vector<Dwell> dwells = DwellsOf(made.signal);
    ASSERT_EQ(dwells.size(), made.start.size());
    for (std::size_t k = 0; k < dwells.size(); ++k) {
      const double cycle = kRate / made.frequencies_Hz[k];
      EXPECT_NEAR(dwells[k].start, made.start[k], 0.25 * cycle);
      EXPECT_NEAR(dwells[k].end, made.end[k], 0.25 * cycle);
    }
  }
}

// Steps of 0.1 Hz are 1 % at 10 Hz, and six cycles of these look like a sweep.
TEST(Dwells, OfStatedFrequenciesAreFoundWhereStepsAreSmall) {
  std::vector<double> frequencies;
  for (int k = 0; k < 116; ++k) frequencies.push_back(0.5 + 0.1 * k);
  const ShortDwells made = MakeShortDwells(frequencies, 6, 0, 1);
  const std::vector<TonePoint> track = TrackTone(made.signal);
  EXPECT_LT(CountFound(made, FindDwells(made.signal, track)), 100U);
  for (double& frequency : frequencies) frequency /= kRate;
  const std::vector<Dwell> stated =
      DwellsOfFrequencies(made.signal, track, FindDwells(made.signal, track), frequencies);
  EXPECT_EQ(stated.size(), 116U);
  // Noise of 6 % of the last ones may move an end by more than 1.3 cycles.
  EXPECT_GE(CountFound(made, stated), 115U);
  EXPECT_TRUE(DwellsOfFrequencies(made.signal, track, {}, std::vector<double>{0.1}).empty());
}

// Half of the way between frequencies far apart is far from both.
TEST(Dwells, OfStatedFrequenciesAreNearThem) {
  const ShortDwells made = MakeShortDwells({2, 5, 10, 15, 20}, 10, 1, 1);
  const std::vector<TonePoint> track = TrackTone(made.signal);
  const std::vector<Dwell> found = DwellsOfFrequencies(made.signal, track, FindDwells(made.signal, track),
                                                       std::vector<double>{2 / kRate, 20 / kRate});
  EXPECT_EQ(found.size(), 2U);
  for (const Dwell& dwell : found) {
    const bool is_first = dwell.cycles_per_sample * kRate < 10;
    const double middle = 0.5 * (dwell.start + dwell.end);
    EXPECT_GT(middle, is_first ? made.start.front() : made.start.back());
    EXPECT_LT(middle, is_first ? made.end.front() : made.end.back());
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
  // Slow sweeps look straight for longest.
  for (const double noise : {0.0, 0.01, 0.05})
    EXPECT_EQ(KindOf(Noisy(LogSweep(1800, kRate), noise, 0, 1)), ExcitationKind::kSweep) << noise;
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
}  // namespace fourpost::dwells_test
