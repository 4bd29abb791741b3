#include "analysis/frequency_response/local_response.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/analysis/frequency_response/known_system.h"

namespace fourpost::local_response_test {
namespace {

constexpr double kRate = 500;

std::vector<LocalResponse> Respond(const std::vector<double>& post, const std::vector<double>& channel,
                                   const std::vector<double>& frequencies_Hz) {
  const std::vector<std::span<const double>> channels = {channel};
  return LocalResponses(post, channels, kRate, frequencies_Hz);
}

TEST(LocalResponse, ToARandomMotionIsThatOfTheSystem) {
  const KnownSystem system(1.3, 0.25, kRate);
  const std::vector<double> post = RandomMotion(120, kRate, 1);
  Coverage coverage;
  for (const LocalResponse& at : Respond(post, system.Answer(post), LogFrequencies(0.5, 30, 40))) {
    EXPECT_GT(at.channels[0].coherence, 0.99999);
    coverage.Add(at.channels[0].response, at.channels[0].variance, system.Response(at.frequency_Hz, kRate));
  }
  // What leakage and a quadratic over the band leave: a tenth of what is asked of a rig, 0.05 dB and 0.3 degrees.
  EXPECT_LT(coverage.worst_dB(), 0.005);
  EXPECT_LT(coverage.worst_deg(), 0.03);
}

TEST(LocalResponse, HasDeviationsThatCoverTheTruth) {
  const KnownSystem system(1.3, 0.25, kRate);
  for (const double noise : {0.001, 0.01}) {
    Coverage coverage;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const std::vector<double> post = RandomMotion(120, kRate, seed);
      for (const LocalResponse& at :
           Respond(Noisy(post, noise, 0.1, seed), Noisy(system.Answer(post), noise, -3, seed + 1000),
                   LogFrequencies(0.5, 10, 30)))
        coverage.Add(at.channels[0].response, at.channels[0].variance, system.Response(at.frequency_Hz, kRate));
    }
    // 720 numbers of 7 degrees of freedom and more, for which 1.96 standard deviations hold 93 to 95 %.
    EXPECT_GT(coverage.percent(), 92);
    EXPECT_LT(coverage.percent(), 98);
  }
}

/// H1 would be low by the share of noise in the reference.
TEST(LocalResponse, IsNotLoweredByNoiseOfTheReference) {
  const std::vector<double> post = RandomMotion(600, kRate, 3);
  const std::vector<double> noisy = Noisy(post, 0.2, 0, 7);
  // At 12 Hz the noise is a tenth of the motion's density.
  const LocalResponse at = Respond(noisy, post, {12.0}).front();
  const double sd = std::sqrt(at.channels[0].variance / 2);
  EXPECT_LT(sd, 0.03);
  EXPECT_NEAR(at.channels[0].response.real(), 1, 3 * sd);
}

TEST(LocalResponse, ToASweepIsThatOfTheSystem) {
  const KnownSystem system(1.3, 0.25, kRate);
  const std::vector<double> post = LogSweep(120, kRate);
  Coverage coverage;
  for (const LocalResponse& at : Respond(post, system.Answer(post), LogFrequencies(1, 25, 40)))
    coverage.Add(at.channels[0].response, at.channels[0].variance, system.Response(at.frequency_Hz, kRate));
  EXPECT_LT(coverage.worst_dB(), 0.05);
  EXPECT_LT(coverage.worst_deg(), 0.3);
}

TEST(LocalResponse, RefusesFrequenciesBeyondTheRate) {
  const std::vector<double> post = RandomMotion(10, kRate, 1);
  EXPECT_THROW(Respond(post, post, {249.9}), std::invalid_argument);
  EXPECT_THROW(Respond(std::vector<double>(10, 0.0), std::vector<double>(10, 0.0), {1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::local_response_test
