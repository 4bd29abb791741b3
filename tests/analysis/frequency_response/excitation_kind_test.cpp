#include "analysis/frequency_response/excitation_kind.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/analysis/frequency_response/known_system.h"

namespace fourpost::excitation_kind_test {
namespace {

constexpr double kRate = 500;
constexpr double kTurn = 2 * std::numbers::pi;

ExcitationKind KindOf(const std::vector<double>& signal) {
  const std::vector<TonePoint> track = TrackTone(signal);
  return KindOf(signal, track, FindDwells(signal, track));
}

/// What 0 to 1 is between two numbers, evenly in octaves.
double Between(double lower, double upper, double share) { return lower * std::pow(upper / lower, share); }

/// Noise of 0.1 to 2 % of the signal.
std::vector<double> WithNoise(std::vector<double> signal, RandomStream& random, std::uint64_t seed) {
  return Noisy(std::move(signal), Between(0.001, 0.02, random.Uniform()), 0.01, seed);
}

/// Three to eight periods of lines of random phases; by turns flat, falling with frequency, and one of them ten times
/// the others; every or every other line; of a twentieth to all in the band.
std::vector<double> Multisine(std::uint64_t seed) {
  RandomStream random(seed, "multisine");
  const auto period = static_cast<std::size_t>(kRate * std::round(Between(4, 20, random.Uniform())));
  const std::size_t periods = 3 + static_cast<std::size_t>(5 * random.Uniform());
  const double period_s = static_cast<double>(period) / kRate;
  const auto first = static_cast<std::size_t>(std::ceil(Between(0.3, 1, random.Uniform()) * period_s));
  const auto last = static_cast<std::size_t>(Between(8, 30, random.Uniform()) * period_s);
  const double kept = Between(0.05, 1, random.Uniform());
  std::vector<std::size_t> lines;
  for (std::size_t line = first; line <= last; line += 1 + seed % 2)
    if (random.Uniform() < kept) lines.push_back(line);
  while (lines.size() < 3) lines.push_back(first + 5 * lines.size());
  const auto dominant = static_cast<std::size_t>(random.Uniform() * static_cast<double>(lines.size()));
  std::vector<double> once(period);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double cycles = static_cast<double>(lines[i]) / static_cast<double>(period);
    const double amplitude = seed % 3 == 0   ? 1
                             : seed % 3 == 1 ? 1 / static_cast<double>(lines[i])
                             : i == dominant ? 10
                                             : 1;
    const double phase = kTurn * random.Uniform();
    for (std::size_t k = 0; k < period; ++k)
      once[k] += amplitude * std::cos(kTurn * cycles * static_cast<double>(k) + phase);
  }
  std::vector<double> signal;
  for (std::size_t k = 0; k < periods; ++k) signal.insert(signal.end(), once.begin(), once.end());
  return WithNoise(std::move(signal), random, seed);
}

/// Ten to thirty cycles at 1 to 40 frequencies, upwards or downwards, with pauses or none, harmonics of 3 %.
std::vector<double> Stepped(std::uint64_t seed) {
  RandomStream random(seed, "stepped");
  const int count = seed % 10 == 0 ? 1 : 2 + static_cast<int>(38 * random.Uniform());
  const double lower_Hz = Between(0.5, 2, random.Uniform());
  const double upper_Hz = Between(8, 30, random.Uniform());
  std::vector<double> frequencies =
      count == 1 ? std::vector<double>{lower_Hz} : LogFrequencies(lower_Hz, upper_Hz, count);
  if (seed % 2 == 1) std::reverse(frequencies.begin(), frequencies.end());
  const double cycles = Between(10, 30, random.Uniform());
  const auto pause = static_cast<std::size_t>(seed % 3 == 0 ? kRate : 0);
  std::vector<double> signal(static_cast<std::size_t>(2 * kRate), 0.0);
  double phase = 0;
  for (const double frequency : frequencies) {
    for (double k = 0; k < std::round(std::max(cycles / frequency, 4.0) * kRate); ++k) {
      phase += kTurn * frequency / kRate;
      signal.push_back(RigAmplitude(frequency) * (std::sin(phase) + 0.03 * std::sin(2 * phase + 0.3)));
    }
    signal.resize(signal.size() + pause, 0.0);
  }
  return WithNoise(std::move(signal), random, seed);
}

/// One to ten minutes, in octaves or evenly, upwards or downwards, once or thrice, with rest about it.
std::vector<double> Sweep(std::uint64_t seed) {
  RandomStream random(seed, "sweep");
  const double lower_Hz = Between(0.3, 1, random.Uniform());
  const double upper_Hz = Between(8, 30, random.Uniform());
  const double samples = std::round(kRate * Between(60, 600, random.Uniform()));
  const int times = seed % 5 == 0 ? 3 : 1;
  std::vector<double> signal(static_cast<std::size_t>(2 * kRate), 0.0);
  double phase = 0;
  for (int time = 0; time < times; ++time)
    for (double k = 0; k < samples; ++k) {
      const double share = seed % 2 == 0 ? k / samples : 1 - k / samples;
      const double frequency =
          seed % 3 == 0 ? lower_Hz + share * (upper_Hz - lower_Hz) : Between(lower_Hz, upper_Hz, share);
      phase += kTurn * frequency / kRate;
      signal.push_back(RigAmplitude(frequency) * std::sin(phase));
    }
  signal.resize(signal.size() + static_cast<std::size_t>(2 * kRate), 0.0);
  return WithNoise(std::move(signal), random, seed);
}

/// One to five minutes, white above a third to one hertz or falling by the first or second power, to some tens of
/// hertz.
std::vector<double> Random(std::uint64_t seed) {
  RandomStream random(seed, "random");
  const double lower = kTurn * Between(0.3, 1, random.Uniform()) / kRate;
  const double upper = kTurn * Between(8, 30, random.Uniform()) / kRate;
  std::vector<double> signal(static_cast<std::size_t>(kRate * Between(60, 300, random.Uniform())));
  for (double& sample : signal) sample = random.Normal();
  const auto smooth = [&](double share) {
    double value = 0;
    for (double& sample : signal) sample = value += share * (sample - value);
  };
  for (std::uint64_t k = 0; k < seed % 3; ++k) smooth(lower);
  for (int k = 0; k < 3; ++k) smooth(upper);
  return WithNoise(std::move(signal), random, seed);
}

/// Seeds of signals that are called otherwise.
std::string Misnamed(const std::function<std::vector<double>(std::uint64_t)>& make, ExcitationKind kind, int count) {
  std::string seeds;
  for (int seed = 1; seed <= count; ++seed)
    if (KindOf(make(static_cast<std::uint64_t>(seed))) != kind) seeds += ' ' + std::to_string(seed);
  return seeds;
}

TEST(ExcitationKind, OfMultisinesIsRight) { EXPECT_EQ(Misnamed(Multisine, ExcitationKind::kMultisine, 90), ""); }
TEST(ExcitationKind, OfSteppedSinesIsRight) { EXPECT_EQ(Misnamed(Stepped, ExcitationKind::kStepped, 50), ""); }
TEST(ExcitationKind, OfSweepsIsRight) { EXPECT_EQ(Misnamed(Sweep, ExcitationKind::kSweep, 30), ""); }
TEST(ExcitationKind, OfRandomMotionsIsRight) { EXPECT_EQ(Misnamed(Random, ExcitationKind::kRandom, 30), ""); }

}  // namespace
}  // namespace fourpost::excitation_kind_test
