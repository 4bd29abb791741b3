#include "analysis/frequency_response/multisine.h"

#include <gtest/gtest.h>

#include "tests/analysis/frequency_response/known_system.h"

namespace fourpost::multisine_test {
namespace {

using std::numbers::pi;

constexpr double kRate = 500;
constexpr std::size_t kPeriod = 5000;

/// Of each four odd lines from 0.5 to 20 Hz one is left out at random, that of others at random phase.
std::vector<double> OddMultisine(int periods, std::uint64_t seed) {
  RandomStream random(seed, "multisine");
  std::vector<double> period(kPeriod, 0.0);
  std::size_t left_out = 0;
  for (std::size_t line = 5; line < 200; line += 2) {
    const std::size_t place = (line - 5) / 2 % 4;
    if (place == 0) left_out = static_cast<std::size_t>(4 * random.Uniform());
    if (place == left_out) continue;
    const double phase = 2 * pi * random.Uniform();
    for (std::size_t k = 0; k < kPeriod; ++k)
      period[k] += 1e-2 / static_cast<double>(line) *
                   std::cos(2 * pi * static_cast<double>(line * k % kPeriod) / kPeriod + phase);
  }
  std::vector<double> signal;
  for (int k = 0; k < periods; ++k) signal.insert(signal.end(), period.begin(), period.end());
  return signal;
}

std::optional<MultisineResponse> Respond(const std::vector<double>& post, const std::vector<double>& channel) {
  const std::vector<std::span<const double>> channels = {channel};
  const std::optional<std::size_t> period = PeriodOf(post);
  EXPECT_EQ(period, kPeriod);
  return RespondToMultisine(post, channels, kPeriod);
}

TEST(Multisine, HasDeviationsThatCoverTheTruth) {
  const KnownSystem system(1.3, 0.25, kRate);
  for (const double noise : {0.001, 0.01}) {
    Coverage coverage;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const std::vector<double> post = OddMultisine(12, seed);
      const auto measured = Respond(Noisy(post, noise, 0.1, seed), Noisy(system.Answer(post), noise, -3, seed + 1000));
      ASSERT_TRUE(measured);
      EXPECT_LT(measured->run_in, 3U);
      for (std::size_t i = 0; i < measured->lines.size(); ++i)
        coverage.Add(measured->channels[0].response[i], measured->channels[0].variance[i],
                     system.Response(static_cast<double>(measured->lines[i]) / 10, kRate));
      EXPECT_LT(measured->channels[0].even_distortion, measured->channels[0].noise);
    }
    EXPECT_GT(coverage.percent(), 92);
    EXPECT_LT(coverage.percent(), 98);
  }
}

TEST(Multisine, TellsDistortionFromNoise) {
  const std::vector<double> post = OddMultisine(12, 1);
  const double size = DeviationOf(post);
  std::vector<double> cubic;
  std::vector<double> square;
  for (const double z : post) {
    cubic.push_back(z + 0.1 * z * z * z / (size * size));
    square.push_back(z + 0.1 * z * z / size);
  }
  const auto odd = Respond(Noisy(post, 1e-3, 0, 1), Noisy(cubic, 1e-3, 0, 2));
  const auto even = Respond(Noisy(post, 1e-3, 0, 1), Noisy(square, 1e-3, 0, 2));
  ASSERT_TRUE(odd && even);
  EXPECT_GT(odd->channels[0].odd_distortion, 0.02);
  EXPECT_LT(odd->channels[0].even_distortion, 1e-3);
  EXPECT_GT(even->channels[0].even_distortion, 0.02);
  EXPECT_LT(even->channels[0].odd_distortion, 1e-3);
  // The noise is that of white noise in the band of the lines: 1e-3 of the post, over 200 of 2500 lines.
  EXPECT_LT(odd->channels[0].noise, 1.5e-3);
}

TEST(Multisine, NeedsAPeriod) {
  EXPECT_EQ(PeriodOf(RandomMotion(60, kRate, 1)), std::nullopt);
  EXPECT_EQ(PeriodOf(std::vector<double>(1000, 1.0)), std::nullopt);
  const std::vector<double> post = OddMultisine(2, 1);
  EXPECT_FALSE(RespondToMultisine(post, {}, kPeriod));
}

}  // namespace
}  // namespace fourpost::multisine_test
