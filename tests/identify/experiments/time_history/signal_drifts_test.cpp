#include "identify/experiments/time_history/signal_drifts.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/signals/random_stream.h"
#include "identify/experiments/time_history/findings.h"
#include "tests/findings.h"

namespace fourpost::signal_drifts_test {
namespace {

constexpr double kRate = 100;
constexpr int kSamples = 6000;

/// From 1 to 8 Hz, with noise, and a rise to the end.
std::vector<double> Motion(double size, double drift, const char* seed) {
  RandomStream random(1, seed);
  std::vector<double> phases;
  for (int i = 0; i < 30; ++i) phases.push_back(random.Uniform());
  std::vector<double> motion;
  for (int k = 0; k < kSamples; ++k) {
    double sum = 0.05 * random.Normal();
    for (int i = 0; i < 30; ++i)
      sum += 0.3 * std::sin(2 * std::numbers::pi * (std::pow(8.0, i / 30.0) * k / kRate + phases[static_cast<std::size_t>(i)]));
    motion.push_back(size * sum + drift * k / kSamples);
  }
  return motion;
}

MeasuredSignal Signal(const char* name, const char* unit, int line, const std::vector<double>& values) {
  return {.name = name,
          .unit = unit,
          .values = WithoutMean(Eigen::Map<const Eigen::VectorXd>(values.data(), kSamples)),
          .source = {.channels = {SourceChannel(name)}, .line = line}};
}

class SignalDrifts : public testing::Test {
 protected:
  SignalDrifts() {
    history_.name = "road";
    history_.rate_Hz = kRate;
    history_.count = kSamples;
    history_.heights = {Motion(0.004, 0, "post")};
    history_.signals = {Signal("s_strut", "m", 5, Motion(0.01, 0, "strut")),
                        Signal("F_tyre", "N", 6, Motion(800, 0, "force"))};
  }

  Diagnostics Found() const {
    Diagnostics found;
    ReportDrifts(history_, "study.yaml", found);
    return found;
  }

  MeasuredHistory history_;
};

TEST_F(SignalDrifts, AreNamedWithWhatToWrite) {
  EXPECT_EQ(Found().Format(), "");
  history_.signals[1] = Signal("F_tyre", "N", 6, Motion(800, 150, "force"));
  EXPECT_THAT(Found(), ReportsOnly(kChannelDrifts, 6, {"'F_tyre' of 'road' drifts by 15", "N over 60 s",
                                                       "'F_tyre: {channel: F_tyre, trend: remove}'"}));
  history_.signals[0] = Signal("s_strut", "m", 5, Motion(0.01, -0.002, "strut"));
  EXPECT_THAT(Found(), testing::AllOf(Reports(kChannelDrifts, 5, {"'s_strut'", "-0.002"}), Reports(kChannelDrifts, 6)));
}

// Of a post that rises, and of a vehicle that was let go, which creeps.
TEST_F(SignalDrifts, AreNoneOfAVehicleThatMovesSo) {
  history_.signals[1] = Signal("F_tyre", "N", 6, Motion(800, 150, "force"));
  MeasuredHistory released = history_;
  released.release = Release{};
  std::swap(history_, released);
  EXPECT_EQ(Found().Format(), "");
  std::swap(history_, released);
  history_.heights = {Motion(0.004, 0.001, "post")};
  EXPECT_EQ(Found().Format(), "");
}

}  // namespace
}  // namespace fourpost::signal_drifts_test
