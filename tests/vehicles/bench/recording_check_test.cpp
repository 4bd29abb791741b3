#include "vehicles/bench/recording_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "vehicles/bench/findings.h"

namespace fourpost::recording_check_test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Not;

constexpr double kLength_m = 0.4;

/// Ten cycles at 1 Hz of 20 mm: 750 N s/m in compression, 1900 in rebound.
TimeRecording Good() {
  TimeRecording recording{.start_s = 0, .end_s = 10, .step_s = 0.002, .channels = {{}, {}}};
  const double w = 2 * std::numbers::pi;
  for (int k = 0; k <= 5000; ++k) {
    const double v = 0.02 * w * std::cos(w * 0.002 * k);
    recording.channels[0].push_back(0.02 * std::sin(w * 0.002 * k));
    recording.channels[1].push_back((v > 0 ? 1900 : 750) * v);
  }
  return recording;
}

void Apply(std::vector<double>& signal, const std::function<double(double)>& change) {
  std::transform(signal.begin(), signal.end(), signal.begin(), change);
}

/// Findings about a recording that cannot be used.
Diagnostics FaultOf(const TimeRecording& recording) {
  Diagnostics diagnostics;
  EXPECT_FALSE(CheckBenchRecording(recording, kLength_m, "bench.csv", diagnostics));
  return diagnostics;
}

/// Findings about one that can.
Diagnostics WarningOf(const TimeRecording& recording) {
  Diagnostics diagnostics;
  EXPECT_TRUE(CheckBenchRecording(recording, kLength_m, "bench.csv", diagnostics));
  return diagnostics;
}

auto ReportsNothing() { return testing::Property("items", &Diagnostics::items, testing::IsEmpty()); }

TEST(RecordingCheck, PassesAGoodOne) { EXPECT_THAT(WarningOf(Good()), ReportsNothing()); }

TEST(RecordingCheck, PassesTheShippedOnes) {
  const std::array<RecordedChannel, 2> wanted = {RecordedChannel{{"displacement"}, kLength, "x"},
                                                 RecordedChannel{{"force"}, kForce, "F"}};
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FOURPOST_SOURCE_DIR "/studies/damper")) {
    if (entry.path().extension() != ".csv") continue;
    ++files;
    Diagnostics diagnostics;
    const auto recording = ReadTimeRecording(entry.path(), wanted, diagnostics);
    ASSERT_TRUE(recording) << diagnostics.Format();
    EXPECT_TRUE(CheckBenchRecording(*recording, kLength_m, entry.path().string(), diagnostics));
    EXPECT_EQ(diagnostics.Format(), "");
  }
  EXPECT_EQ(files, 16);
}

TEST(RecordingCheck, TellsAForceThatDies) {
  TimeRecording recording = Good();
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.2);
  for (std::size_t k = 2000; k < 3500; ++k) recording.channels[1][k] = 12 + noise(random);
  EXPECT_THAT(FaultOf(recording), ReportsOnly(kForceDeadInCycle, 0, {" 4.", "333 N"}));
}

/// At an eighth of the speed a cubic law has a five-hundredth of the force, which is no fault of the channel.
TEST(RecordingCheck, PassesACubicLawThatSlowsDown) {
  TimeRecording recording = Good();
  const double w = 2 * std::numbers::pi;
  for (std::size_t k = 0; k < recording.samples(); ++k) {
    const double t = recording.step_s * static_cast<double>(k);
    const double amplitude = 0.02 * std::exp(-0.2 * t);
    recording.channels[0][k] = amplitude * std::sin(w * t);
    recording.channels[1][k] = 3e4 * std::pow(amplitude * w * std::cos(w * t), 3);
  }
  EXPECT_THAT(WarningOf(recording), Not(AnyOf(Reports(kForceDead), Reports(kForceDeadInCycle))));
}

TEST(RecordingCheck, TellsSwappedColumns) {
  TimeRecording recording = Good();
  std::swap(recording.channels[0], recording.channels[1]);
  EXPECT_THAT(FaultOf(recording), ReportsOnly(kChannelsSwapped, 0, {"333 m", "0.04 N"}));
}

TEST(RecordingCheck, TellsAWrongSign) {
  for (const std::size_t channel : {0, 1}) {
    TimeRecording recording = Good();
    Apply(recording.channels[channel], [](double value) { return -value; });
    EXPECT_THAT(FaultOf(recording), ReportsOnly(kForceSign, 0, {"10.5 W"}));
    EXPECT_TRUE(IsForceReversed(recording));
  }
  EXPECT_FALSE(IsForceReversed(Good()));
}

TEST(RecordingCheck, TakesNoDelayAndNoDeadForceForAWrongSign) {
  TimeRecording late = Good();
  std::rotate(late.channels[1].begin(), late.channels[1].end() - 60, late.channels[1].end());
  EXPECT_FALSE(IsForceReversed(late));
  TimeRecording dead = Good();
  Apply(dead.channels[1], [](double) { return 3.0; });
  EXPECT_FALSE(IsForceReversed(dead));
}

TEST(RecordingCheck, SuspectsTwoWrongSigns) {
  TimeRecording recording = Good();
  for (std::vector<double>& channel : recording.channels) Apply(channel, [](double value) { return -value; });
  EXPECT_THAT(WarningOf(recording), Reports(kSidesSwapped, {"factor of 2.5"}));
}

// Neither gas nor the load cell's offset does net work over a cycle.
TEST(RecordingCheck, TakesNoGasAndNoOffsetForAHardCompression) {
  for (const auto& [gas_N, offset_N] : {std::pair(300.0, 0.0), {0.0, -300.0}, {0.0, 300.0}}) {
    TimeRecording recording = Good();
    for (std::size_t k = 0; k < recording.channels[0].size(); ++k)
      recording.channels[1][k] += offset_N - gas_N * std::pow(0.1 / (0.1 + recording.channels[0][k]), 1.2);
    EXPECT_THAT(WarningOf(recording), ReportsNothing()) << gas_N << ' ' << offset_N;
    for (std::vector<double>& channel : recording.channels) Apply(channel, [](double value) { return -value; });
    EXPECT_THAT(WarningOf(recording), Reports(kSidesSwapped)) << gas_N << ' ' << offset_N;
  }
}

TEST(RecordingCheck, TellsMillimetresForMetres) {
  TimeRecording recording = Good();
  Apply(recording.channels[0], [](double value) { return 1000 * value; });
  EXPECT_THAT(FaultOf(recording), ReportsOnly(kStrokeTooLong, 0, {"40 m", "0.4 m"}));
}

TEST(RecordingCheck, TellsMetresForMillimetres) {
  TimeRecording recording = Good();
  Apply(recording.channels[0], [](double value) { return 1e-4 * value; });
  EXPECT_THAT(WarningOf(recording), Reports(kStrokeTooShort, {"4e-6 m"}));
}

TEST(RecordingCheck, TellsClippedForce) {
  TimeRecording recording = Good();
  Apply(recording.channels[1], [](double value) { return std::min(value, 200.0); });
  EXPECT_THAT(FaultOf(recording), Reports(kClipped, {"force", "200 N exactly"}));
}

TEST(RecordingCheck, TellsBothSidesOfAClippedForce) {
  TimeRecording recording = Good();
  Apply(recording.channels[1], [](double value) { return std::clamp(value, -70.0, 200.0); });
  EXPECT_THAT(FaultOf(recording), Reports(kClipped, {"200 N exactly", "-70 N exactly", "the first at 0 s"}));
}

// What the remedy says leads to recordings that are taken.
TEST(RecordingCheck, TakesTheWholeCyclesBesideAClippedStretch) {
  TimeRecording recording = Good();
  for (std::size_t k = 0; k < recording.samples(); ++k) {
    double& force = recording.channels[1][k];
    force = k >= 2000 && k < 3000 ? std::min(force, 200.0) : 0.8 * force;
  }
  EXPECT_THAT(FaultOf(recording), Reports(kClipped));
  for (std::vector<double>& channel : recording.channels) channel.resize(1900);
  recording.end_s = recording.time_s(1899);
  EXPECT_THAT(WarningOf(recording), ReportsNothing());
}

// Noise that came in behind what clipped.
TEST(RecordingCheck, TellsClippingUnderNoise) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> noise(0, 0.3);
  TimeRecording recording = Good();
  Apply(recording.channels[1], [&](double value) { return std::min(value, 200.0) + noise(engine); });
  EXPECT_THAT(WarningOf(recording), Reports(kLooksClipped, {"force", "200 N but for noise of 0."}));
  TimeRecording whole = Good();
  Apply(whole.channels[1], [&](double value) { return value + noise(engine); });
  EXPECT_THAT(WarningOf(whole), ReportsNothing());
}

TEST(RecordingCheck, TellsClippedDisplacementFromBelow) {
  TimeRecording recording = Good();
  Apply(recording.channels[0], [](double value) { return std::max(value, -0.015); });
  EXPECT_THAT(FaultOf(recording), Reports(kClipped, {"displacement"}));
}

/// To a multiple of `level`.
std::function<double(double)> Levels(double level) {
  return [level](double value) { return level * std::round(value / level); };
}

// A crest rounded to levels is flat as well, and not clipped.
TEST(RecordingCheck, DoesNotTakeLevelsForClipping) {
  TimeRecording recording = Good();
  Apply(recording.channels[0], Levels(5e-6));
  Apply(recording.channels[1], Levels(1));
  EXPECT_THAT(WarningOf(recording), ReportsNothing());
}

TEST(RecordingCheck, TellsCoarseLevels) {
  TimeRecording recording = Good();
  Apply(recording.channels[0], Levels(2e-4));
  Apply(recording.channels[1], Levels(60));
  EXPECT_THAT(WarningOf(recording),
              AllOf(Reports(kDisplacementCoarse, {"0.0002 m", "%"}), Reports(kForceCoarse, {"60 N", "360 N"})));
}

TEST(RecordingCheck, TellsDrift) {
  TimeRecording recording = Good();
  for (std::size_t k = 0; k < recording.samples(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(recording.samples());
    recording.channels[0][k] += 0.008 * share;
    recording.channels[1][k] += 80 * share;
  }
  EXPECT_THAT(WarningOf(recording), AllOf(Reports(kSignalDrifts, {"displacement", "0.008"}),
                                          Reports(kSignalDrifts, {"force at the turning points"})));
}

// Swings that grow out of a rest within a cycle, and fall into it, have their middles elsewhere.
TEST(RecordingCheck, TakesTheWayOutOfARestForNoDrift) {
  TimeRecording recording = Good();
  for (std::vector<double>& channel : recording.channels) {
    channel.resize(500 * 7 + 1);
    for (std::size_t k = 0; k < 400; ++k) {
      const double ramp = static_cast<double>(k) / 400;
      channel[k] *= ramp;
      channel[channel.size() - 1 - k] *= ramp;
    }
    channel.insert(channel.begin(), 500, 0.0);
    channel.insert(channel.end(), 500, 0.0);
  }
  recording.end_s = 9;
  EXPECT_THAT(WarningOf(recording), ReportsNothing());
}

// 3 % of the largest force within a minute.
TEST(RecordingCheck, TellsADriftOfTheForceBesideTheMotion) {
  TimeRecording recording = Good();
  for (std::vector<double>& channel : recording.channels) {
    const std::vector<double> once(channel.begin(), channel.end() - 1);
    for (int k = 1; k < 6; ++k) channel.insert(channel.end() - 1, once.begin(), once.end());
  }
  recording.end_s = 60;
  EXPECT_THAT(WarningOf(recording), ReportsNothing());
  for (std::size_t k = 0; k < recording.samples(); ++k)
    recording.channels[1][k] += 7.2 * static_cast<double>(k) / static_cast<double>(recording.samples());
  EXPECT_THAT(WarningOf(recording), ReportsOnly(kSignalDrifts, 0, {"force drifts by 7", "N from begin to end"}));
}

TEST(RecordingCheck, TellsADeadForceChannel) {
  TimeRecording recording = Good();
  Apply(recording.channels[1], [](double) { return 1.5; });
  EXPECT_THAT(FaultOf(recording), ReportsOnly(kForceDead, 0, {"1.5 N"}));
}

TEST(RecordingCheck, TellsAForceThatIsOnlyNoise) {
  TimeRecording recording = Good();
  std::mt19937_64 engine(1);
  std::normal_distribution<double> noise(0, 1);
  Apply(recording.channels[1], [&](double value) { return 1e-4 * value + noise(engine); });
  EXPECT_THAT(WarningOf(recording), Reports(kForceUnrelated));
}

TEST(RecordingCheck, TellsSpikes) {
  TimeRecording recording = Good();
  recording.channels[1][700] = 5000;
  recording.channels[0][2000] = 0.1;
  EXPECT_THAT(WarningOf(recording),
              AllOf(Reports(kSpike, {"force", "1.4 s", "5000 N"}), Reports(kSpike, {"displacement", "4 s", "0.1 m"})));
}

/// Sines of 1 to 20 Hz of 0.1 m/s, a bilinear dashpot whose force comes `delay_s` later.
TimeRecording Delayed(double delay_s) {
  TimeRecording recording{.start_s = 0, .end_s = 8, .step_s = 0.002, .channels = {{}, {}}};
  const auto speed = [](double t) { return 0.1 * std::cos(2 * std::numbers::pi * (t + 19 * t * t / 16)); };
  double x = 0;
  for (int k = 0; k <= 4000; ++k) {
    const double t = 0.002 * k;
    const double v = speed(t - delay_s);
    recording.channels[0].push_back(x);
    recording.channels[1].push_back((v > 0 ? 1900 : 750) * v);
    for (int j = 0; j < 10; ++j) x += 0.0002 * speed(t + 0.0002 * (j + 0.5));
  }
  return recording;
}

TEST(RecordingCheck, TellsForceThatComesTooEarlyOrTooLateForADamper) {
  EXPECT_THAT(WarningOf(Delayed(0)), ReportsNothing());
  // As a series spring would make it.
  EXPECT_THAT(WarningOf(Delayed(0.004)), Not(AnyOf(Reports(kForceAhead), Reports(kForceLate))));
  EXPECT_THAT(WarningOf(Delayed(-0.004)), Reports(kForceAhead, {"3.8 ms", "19 Hz"}));
  EXPECT_THAT(WarningOf(Delayed(0.018)), Reports(kForceLate, {"18 ms", " 1"}));
}

// Of the shipped sweep 20 ms late the force at the turning points is that of speeds that grow.
TEST(RecordingCheck, ALateForceIsNoDrift) {
  const std::array<RecordedChannel, 2> wanted = {RecordedChannel{{"displacement"}, kLength, "x"},
                                                 RecordedChannel{{"force"}, kForce, "F"}};
  Diagnostics diagnostics;
  auto recording = ReadTimeRecording(FOURPOST_SOURCE_DIR "/studies/damper/sweep.csv", wanted, diagnostics);
  ASSERT_TRUE(recording) << diagnostics.Format();
  std::vector<double>& force = recording->channels[1];
  std::rotate(force.begin(), force.end() - 10, force.end());
  EXPECT_THAT(WarningOf(*recording), AllOf(Reports(kForceLate, {" 2"}), Not(Reports(kSignalDrifts))));
}

// As where samples are missing and the times were closed up.
TEST(RecordingCheck, TellsAJump) {
  TimeRecording recording = Good();
  for (std::vector<double>& channel : recording.channels) channel.erase(channel.begin() + 1200, channel.begin() + 1350);
  recording.end_s = recording.time_s(recording.samples() - 1);
  EXPECT_THAT(FaultOf(recording), Reports(kDisplacementJumps, {"2.398 s"}));
}

/// Every `stride`th sample of the sweep up to 20 Hz, which is recorded at 500 Hz.
TimeRecording Thinned(std::size_t stride) {
  const TimeRecording fast = Delayed(0);
  TimeRecording slow{.start_s = 0, .end_s = 8, .step_s = 0.002 * static_cast<double>(stride), .channels = {{}, {}}};
  for (std::size_t k = 0; k < fast.samples(); k += stride)
    for (const std::size_t c : {0, 1}) slow.channels[c].push_back(fast.channels[c][k]);
  return slow;
}

// Of a good one samples that stand out, delays and drift would be those between samples.
TEST(RecordingCheck, TellsNothingOfAGoodOneButThatItIsSampledTooSlowly) {
  for (const std::size_t stride : {5, 10, 20}) {
    EXPECT_THAT(WarningOf(Thinned(stride)), ReportsOnly(kSampledSlowly, 0, {std::to_string(500 / stride) + " Hz"}));
  }
}

// 25 to 6 samples in the fastest cycles.
TEST(RecordingCheck, TellsNothingOfAGoodOneThatIsSampledWellEnough) {
  for (const std::size_t stride : {1, 2, 3, 4}) EXPECT_THAT(WarningOf(Thinned(stride)), ReportsNothing()) << stride;
}

TEST(RecordingCheck, TellsAWrongSignOfWhatIsSampledTooSlowly) {
  for (const std::size_t stride : {5, 10})
    for (const std::size_t channel : {0, 1}) {
      TimeRecording slow = Thinned(stride);
      Apply(slow.channels[channel], [](double value) { return -value; });
      EXPECT_THAT(FaultOf(slow), AllOf(Reports(kSampledSlowly), Reports(kForceSign)));
    }
}

// Five samples in each cycle: no cycle is long enough for a phase of its own.
TEST(RecordingCheck, TellsAWrongSignOfASineThatIsSampledTooSlowly) {
  TimeRecording sine{.start_s = 0, .end_s = 4, .step_s = 0.0101, .channels = {{}, {}}};
  for (int k = 0; k <= 396; ++k) {
    const double phase = 2 * std::numbers::pi * 20 * sine.step_s * k;
    sine.channels[0].push_back(8e-4 * std::sin(phase));
    sine.channels[1].push_back(130 * std::cos(phase));
  }
  EXPECT_THAT(WarningOf(sine), Not(AnyOf(Reports(kForceSign), Reports(kSidesSwapped))));
  Apply(sine.channels[1], [](double value) { return -value; });
  EXPECT_THAT(FaultOf(sine), Reports(kForceSign));
}

TEST(RecordingCheck, TellsSwappedColumnsAndUnitsOfWhatIsSampledTooSlowly) {
  for (const std::size_t stride : {5, 10}) {
    TimeRecording swapped = Thinned(stride);
    std::swap(swapped.channels[0], swapped.channels[1]);
    EXPECT_THAT(FaultOf(swapped), Reports(kChannelsSwapped));
    TimeRecording millimetres = Thinned(stride);
    Apply(millimetres.channels[0], [](double value) { return 1000 * value; });
    EXPECT_THAT(FaultOf(millimetres), Reports(kStrokeTooLong));
    TimeRecording metres = Thinned(stride);
    Apply(metres.channels[0], [](double value) { return 1e-4 * value; });
    EXPECT_THAT(WarningOf(metres), Reports(kStrokeTooShort));
  }
}

TEST(RecordingCheck, TellsADeadForceOfItsNoise) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.2);
  TimeRecording dead = Thinned(1);
  for (double& force : dead.channels[1]) force = 12 + 0.2 * std::round(noise(random) / 0.2);
  EXPECT_THAT(FaultOf(dead), ReportsOnly(kForceDead, 0, {"12 N but for noise of its converter throughout"}));
}

TEST(RecordingCheck, TellsADeadForceOfWhatIsSampledTooSlowly) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.2);
  for (const std::size_t stride : {5, 10}) {
    TimeRecording dies = Thinned(stride);
    for (std::size_t k = dies.samples() / 3; k < 2 * dies.samples() / 3; ++k) dies.channels[1][k] = 12 + noise(random);
    EXPECT_THAT(FaultOf(dies), Reports(kForceDeadInCycle));
    TimeRecording dead = Thinned(stride);
    for (double& force : dead.channels[1]) force = 1e-4 * force + noise(random);
    EXPECT_THAT(WarningOf(dead), Reports(kForceUnrelated));
  }
}

TEST(RecordingCheck, TellsLessThanOneCycle) {
  TimeRecording recording = Good();
  for (std::vector<double>& channel : recording.channels) channel.resize(350);
  recording.end_s = 0.7;
  EXPECT_THAT(FaultOf(recording), ReportsOnly(kCycleIncomplete, 0, {"once", "0.7 s"}));
}

}  // namespace
}  // namespace fourpost::recording_check_test
