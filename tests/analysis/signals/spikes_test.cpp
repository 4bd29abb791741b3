#include "analysis/signals/spikes.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace fourpost::spikes_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Ten cycles of 25 samples, with steps at both ends of the swing as friction makes them.
std::vector<double> Sine(double step) {
  std::vector<double> signal;
  for (int k = 0; k < 250; ++k) {
    const double phase = 2 * M_PI * k / 25;
    signal.push_back(std::sin(phase) + std::copysign(step, std::cos(phase)));
  }
  return signal;
}

TEST(Spikes, AreSamplesThatStandOut) {
  std::vector<double> signal = Sine(0);
  signal[40] += 1;
  signal[120] = signal[121] = -3;
  EXPECT_THAT(Spikes(signal), ElementsAre(40, 120, 121));
}

TEST(Spikes, AreNoStepsAndNoCrests) {
  EXPECT_THAT(Spikes(Sine(0)), IsEmpty());
  EXPECT_THAT(Spikes(Sine(0.5)), IsEmpty());
  EXPECT_THAT(Spikes(std::vector<double>(4, 1)), IsEmpty());
  EXPECT_THAT(Spikes(std::vector<double>(40, 1)), IsEmpty());
}

TEST(Spikes, AreNoNoise) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> noise(0, 1);
  std::vector<double> signal(10000);
  for (double& sample : signal) sample = noise(engine);
  EXPECT_THAT(Spikes(signal), IsEmpty());
  signal[5000] = 20;
  EXPECT_THAT(Spikes(signal), ElementsAre(5000));
}

}  // namespace
}  // namespace fourpost::spikes_test
