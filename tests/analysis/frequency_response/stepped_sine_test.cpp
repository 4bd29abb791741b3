#include "analysis/frequency_response/stepped_sine.h"

#include <gtest/gtest.h>

#include "analysis/frequency_response/rest_level.h"
#include "tests/analysis/frequency_response/known_system.h"

namespace fourpost::stepped_sine_test {
namespace {

constexpr double kRate = 500;

std::vector<DwellResponse> Respond(const std::vector<double>& post, const std::vector<double>& channel) {
  return RespondInDwells({.rate_Hz = kRate, .posts = {post}, .channels = {channel}}, FindDwells(post, TrackTone(post)));
}

TEST(SteppedSine, IsTheResponseOfALinearSystem) {
  const KnownSystem system(1.3, 0.25, kRate);
  const std::vector<double> post = SteppedSine(LogFrequencies(0.5, 30, 40), 20, kRate);
  const std::vector<double> channel = system.Answer(post);
  const std::vector<DwellResponse> responses = Respond(post, channel);
  ASSERT_EQ(responses.size(), 40U);
  Coverage coverage;
  for (const DwellResponse& at : responses) {
    // At the highest frequencies the system's own ringing lasts for half of the four seconds.
    EXPECT_TRUE(at.is_settled || at.frequency_Hz > 20);
    EXPECT_NEAR(at.amplitude / RigAmplitude(at.frequency_Hz), 1, 1e-4);
    coverage.Add(at.channels[0].response, at.channels[0].variance, system.Response(at.frequency_Hz, kRate));
  }
  // What is left of the run-in is below a thousandth, which is 0.01 dB.
  EXPECT_LT(coverage.worst_dB(), 0.01);
  EXPECT_LT(coverage.worst_deg(), 0.06);
}

TEST(SteppedSine, HasDeviationsThatCoverTheTruth) {
  const KnownSystem system(1.3, 0.25, kRate);
  const std::vector<double> post = SteppedSine(LogFrequencies(0.5, 12, 30), 20, kRate);
  const std::vector<double> channel = system.Answer(post);
  for (const double noise : {0.001, 0.01}) {
    Coverage coverage;
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
      for (const DwellResponse& at : Respond(Noisy(post, noise, 0.1, seed), Noisy(channel, noise, -3, seed + 1000)))
        coverage.Add(at.channels[0].response, at.channels[0].variance, system.Response(at.frequency_Hz, kRate));
    // 360 numbers: a share of 95 % is good to 1.1.
    EXPECT_GT(coverage.percent(), 92);
    EXPECT_LT(coverage.percent(), 98.5);
  }
}

/// Dwells of `cycles`, of any length in time, in steps of `ratio` from 0.5 to 3 Hz, after and before two seconds of
/// rest.
std::vector<double> ShortDwells(double cycles, double ratio, double pause_s) {
  std::vector<double> post(static_cast<std::size_t>(2 * kRate), 0.0);
  double phase = 0;
  for (double frequency = 0.5; frequency < 3; frequency *= ratio) {
    const double samples = std::round(cycles / frequency * kRate);
    for (double k = 0; k < samples; ++k) {
      phase += 2 * std::numbers::pi * frequency / kRate;
      post.push_back(RigAmplitude(frequency) * std::sin(phase));
    }
    post.resize(post.size() + static_cast<std::size_t>(pause_s * kRate), 0.0);
  }
  post.resize(post.size() + static_cast<std::size_t>(2 * kRate), 0.0);
  return post;
}

// In short dwells the run-in is not over: what scatters less than 0.05 dB must be right to that, and deviations hold
// what is left of the run-in.
TEST(SteppedSine, OfFewCyclesIsRightWhereItSaysSo) {
  const KnownSystem system(1.3, 0.25, kRate);
  for (const double pause_s : {0.0, 2.0})
    for (const double cycles : {4.0, 6.0, 8.0}) {
      const std::vector<double> post = ShortDwells(cycles, 1.05, pause_s);
      const std::vector<double> channel = system.Answer(post);
      Coverage coverage;
      Coverage sharp;
      std::size_t found = 0;
      for (std::uint64_t seed = 1; seed <= 3; ++seed)
        for (const DwellResponse& at : Respond(Noisy(post, 0.01, 0.1, seed), Noisy(channel, 0.01, -3, seed + 1000))) {
          ++found;
          const std::complex<double> truth = system.Response(at.frequency_Hz, kRate);
          const DwellChannel& measured = at.channels[0];
          coverage.Add(measured.response, measured.variance, truth);
          // Three standard deviations below 0.05 dB, which is 0.3 degrees.
          if (3 * std::sqrt(measured.variance / 2) < 5.5e-3 * std::abs(measured.response))
            sharp.Add(measured.response, measured.variance, truth);
        }
      // A dwell that noise parts in two counts twice.
      EXPECT_GE(found, 3U * 37U);
      EXPECT_LE(found, 3U * 37U + 1);
      EXPECT_GT(coverage.percent(), 92);
      EXPECT_LT(sharp.worst_dB(), 0.05);
      EXPECT_LT(sharp.worst_deg(), 0.3);
    }
}

// Ten cycles in blocks of four: the last one would reach into the pause, and its response be half of the true one.
TEST(SteppedSine, OfShortDwellsDoesNotReachIntoAPause) {
  for (const double frequency_Hz : {40.0, 63.0, 90.0, 120.0})
    for (const double cycles : {12.0, 16.0, 20.0}) {
      std::vector<double> post(static_cast<std::size_t>(2 * kRate), 0.0);
      const std::size_t begin = post.size();
      for (double k = 0; k < std::round(cycles / frequency_Hz * kRate); ++k)
        post.push_back(1e-3 * std::sin(2 * std::numbers::pi * frequency_Hz / kRate * k));
      const std::size_t end = post.size();
      post.resize(post.size() + static_cast<std::size_t>(2 * kRate), 0.0);
      const std::vector<double> noisy = Noisy(post, 0.01, 0, 1);
      for (const DwellResponse& at : Respond(noisy, noisy)) {
        const double cycle = kRate / frequency_Hz;
        EXPECT_GT(static_cast<double>(at.first), static_cast<double>(begin) - 0.3 * cycle);
        EXPECT_LT(static_cast<double>(at.last), static_cast<double>(end) + 0.3 * cycle);
        EXPECT_NEAR(at.amplitude, 1e-3, 0.02e-3) << frequency_Hz << ' ' << cycles;
      }
    }
}

TEST(SteppedSine, HasHarmonicsAndMeansFromRest) {
  const std::vector<double> post = SteppedSine({1, 2, 4}, 20, kRate);
  std::vector<double> channel;
  // cos^2 has a mean of a half and a second harmonic of a half.
  for (const double z : post) channel.push_back(7 + 2 * z + 5 * z * z);
  const std::vector<Dwell> dwells = FindDwells(post, TrackTone(post));
  const RigSignals signals{.rate_Hz = kRate, .posts = {post}, .channels = {channel}};
  const std::vector<RestLevel> rest = RestBefore(signals, dwells).levels;
  ASSERT_EQ(rest.size(), 1U);
  const std::vector<DwellResponse> responses = RespondInDwells(signals, dwells);
  ASSERT_EQ(responses.size(), 3U);
  for (const DwellResponse& at : responses) {
    const double square = 5 * at.amplitude * at.amplitude / 2;
    EXPECT_NEAR(at.channels[0].harmonics[1], square, 1e-3 * square);
    EXPECT_NEAR(at.channels[0].mean - rest[0].mean, square, 1e-3 * square);
    EXPECT_NEAR(at.channels[0].Distortion(), square / (2 * at.amplitude), 1e-4);
  }
}

/// Dwells of `cycles` back to back, from 0.7 to 20 Hz, and where a channel's mean ends in each: it jumps where the
/// frequency does.
struct MovingMeans {
  std::vector<double> post = std::vector<double>(static_cast<std::size_t>(2 * kRate), 0.0);
  std::vector<double> level = post;

  explicit MovingMeans(double cycles) {
    double phase = 0;
    for (double frequency = 0.7; frequency < 20; frequency *= 1.12)
      for (double k = 0; k < std::round(cycles / frequency * kRate); ++k) {
        phase += 2 * std::numbers::pi * frequency / kRate;
        post.push_back(RigAmplitude(frequency) * std::sin(phase));
        level.push_back(LevelAt(frequency));
      }
    post.resize(post.size() + static_cast<std::size_t>(kRate), 0.0);
    level.resize(post.size(), 0.0);
  }

  /// Dampers jack a body down where struts are fast, near its own mode and that of the axles [m].
  static double LevelAt(double frequency_Hz) {
    const double axle = std::log(frequency_Hz / 9) / 0.4;
    const double body = std::log(frequency_Hz / 1.5) / 0.3;
    return -2e-3 * std::exp(-0.5 * body * body) - 1e-3 * std::exp(-0.5 * axle * axle);
  }
};

// A body settles by its own modes, whatever the frequency of the posts.
TEST(SteppedSine, HasDeviationsOfMeansThatAllowForWhatIsNotSettled) {
  for (const double resonance_Hz : {0.7, 1.3, 2.0})
    for (const double cycles : {5.0, 8.0, 20.0}) {
      const KnownSystem system(resonance_Hz, 0.25, kRate);
      const MovingMeans moving(cycles);
      std::vector<double> channel = system.Answer(moving.post);
      const std::vector<double> level = system.Answer(moving.level);
      for (std::size_t k = 0; k < channel.size(); ++k) channel[k] += level[k];
      int within = 0;
      int all = 0;
      for (std::uint64_t seed = 1; seed <= 3; ++seed)
        for (const DwellResponse& at :
             Respond(Noisy(moving.post, 0.01, 0, seed), Noisy(channel, 0.01, 0, seed + 1000))) {
          ++all;
          const DwellChannel& measured = at.channels[0];
          const double error = measured.mean - MovingMeans::LevelAt(at.frequency_Hz);
          if (std::abs(error) < 1.96 * std::sqrt(measured.mean_variance)) ++within;
        }
      // Some 28 frequencies; the errors of one are the same in all three.
      EXPECT_GE(all, 3 * 26) << resonance_Hz << " Hz, " << cycles;
      EXPECT_GE(within, 0.9 * all) << resonance_Hz << " Hz, " << cycles;
    }
}

// In a pause between dwells a vehicle rings down: only what was before the first counts.
TEST(SteppedSine, HasItsRestBeforeThePostsMove) {
  std::vector<double> post = SteppedSine({2}, 20, kRate);
  std::vector<double> channel(post.size(), 3.0);
  post.resize(post.size() + static_cast<std::size_t>(2 * kRate), 0.0);
  channel.resize(post.size(), 5.0);
  const std::vector<double> again = SteppedSine({4}, 20, kRate);
  post.insert(post.end(), again.begin(), again.end());
  channel.resize(post.size(), 5.0);
  const std::vector<Dwell> dwells = FindDwells(post, TrackTone(post));
  const std::vector<RestLevel> rest =
      RestBefore({.rate_Hz = kRate, .posts = {post}, .channels = {channel}}, dwells).levels;
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_EQ(rest[0].mean, 3.0);
  EXPECT_EQ(rest[0].variance, 0.0);
  // From the first sine on there is none.
  const std::size_t begin = static_cast<std::size_t>(2.1 * kRate);
  const std::span<const double> moving = std::span<const double>(post).subspan(begin);
  const Rest none = RestBefore({.rate_Hz = kRate, .posts = {moving}, .channels = {moving}}, dwells);
  EXPECT_TRUE(none.levels.empty());
  EXPECT_NEAR(none.motion, RigAmplitude(2), 0.05 * RigAmplitude(2));
  EXPECT_NEAR(none.frequency_Hz, 2, 0.01);
  EXPECT_NEAR(none.limit, 5e-3 * RigAmplitude(2), 1e-3 * RigAmplitude(2));
}

// A sensor's noise of 20 um beside small amplitudes, and hum of 50 Hz, are no motion; a slow drift is one, and so is a
// dwell that begins at once.
TEST(SteppedSine, IsAtRestBesideNoise) {
  std::vector<double> post(static_cast<std::size_t>(2 * kRate), 0.0);
  for (const double frequency_Hz : {16.0, 20.0, 28.0})
    for (double k = 0; k < 2 * kRate; ++k)
      post.push_back(1.5e-3 * std::sin(2 * std::numbers::pi * frequency_Hz / kRate * k));
  RandomStream random(1, "noise");
  for (std::size_t k = 0; k < post.size(); ++k)
    post[k] += 20e-6 * random.Normal() + 20e-6 * std::sin(2 * std::numbers::pi * 50 / kRate * static_cast<double>(k));
  const std::vector<Dwell> dwells = FindDwells(post, TrackTone(post));
  ASSERT_EQ(dwells.size(), 3U);
  const auto rest = [&](std::span<const double> signal) {
    return RestBefore({.rate_Hz = kRate, .posts = {signal}, .channels = {signal}}, dwells);
  };
  ASSERT_EQ(rest(post).levels.size(), 1U);
  EXPECT_LT(std::abs(rest(post).levels[0].mean), 3e-6);
  EXPECT_TRUE(rest(std::span<const double>(post).subspan(static_cast<std::size_t>(2 * kRate))).levels.empty());
  std::vector<double> drifting = post;
  for (std::size_t k = 0; k < drifting.size(); ++k) drifting[k] += 1e-4 * static_cast<double>(k) / kRate;
  EXPECT_TRUE(rest(drifting).levels.empty());
}

TEST(SteppedSine, IsRelativeToThePatternOfThePosts) {
  const std::vector<double> front = SteppedSine({1, 2, 4}, 20, kRate);
  std::vector<double> rear;
  for (const double z : front) rear.push_back(-1.02 * z);
  const RigSignals signals{.rate_Hz = kRate, .posts = {front, rear}, .channels = {front}};
  for (const DwellResponse& at : RespondInDwells(signals, FindDwells(front, TrackTone(front)))) {
    EXPECT_EQ(at.shares.share, (std::vector<double>{1, -1}));
    EXPECT_NEAR(at.channels[0].response.real(), 1 / 1.01, 1e-9);
    EXPECT_NEAR(at.shares.rest, 0.0099, 1e-4);
  }
}

// Of posts that move alike, either may look the larger by noise: a share has a deviation of 0.06 at 28 Hz here.
TEST(SteppedSine, HasOnePatternAlsoInNoise) {
  const double noise_m = 1.5 * RigAmplitude(28);
  int count = 0;
  for (int seed = 1; seed <= 20; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed), "noise");
    const std::vector<double> clean = SteppedSine({24, 28}, 12, kRate);
    std::vector<double> front = clean;
    std::vector<double> rear = clean;
    for (double& z : front) z += noise_m * random.Normal();
    for (double& z : rear) z += noise_m * random.Normal();
    const RigSignals signals{.rate_Hz = kRate, .posts = {front, rear}, .channels = {front}};
    for (const DwellResponse& at : RespondInDwells(signals, FindDwells(clean, TrackTone(clean)))) {
      ++count;
      EXPECT_EQ(at.shares.share, (std::vector<double>{1, 1})) << seed << ' ' << at.frequency_Hz;
      EXPECT_EQ(at.shares.reference, 0U);
    }
  }
  EXPECT_GE(count, 30);
}

// 0.85 +- 0.02 is no 1, 0.85 +- 0.06 may be.
TEST(PostShares, AreWholeWithinTheirNoise) {
  const auto shares = [](double deviation) {
    return SharesOf({{1, 0.85}, {0.85, 0.7225}}, std::nullopt, {{0, deviation}, {deviation, 0}}).share;
  };
  EXPECT_EQ(shares(0.02), (std::vector<double>{1, 0.9}));
  EXPECT_EQ(shares(0.06), (std::vector<double>{1, 1}));
  // The rear one is larger, the front one comes first; half of it stays half.
  EXPECT_EQ(
      SharesOf({{0.7225, -0.85, 0}, {-0.85, 1, 0}, {0, 0, 0}}, std::nullopt, {{0, 0.06, 0}, {0.06, 0, 0}, {0, 0, 0}}),
      (PostShares{{1, -1, 0}, 0, 0}));
  EXPECT_EQ(SharesOf({{0.25, 0.5}, {0.5, 1}}, std::nullopt, {{0, 0.1}, {0.1, 0}}), (PostShares{{0.5, 1}, 1, 0}));
}

TEST(PostShares, AreNamedByCorners) {
  const std::vector<std::string> corners = {"post_FL", "post_FR", "post_RL", "post_RR"};
  const auto name = [&](std::vector<double> shares) { return PatternOf({std::move(shares), 0, 0}, corners); };
  EXPECT_EQ(name({1, 1, 1, 1}), "heave");
  EXPECT_EQ(name({1, 1, -1, -1}), "pitch");
  EXPECT_EQ(name({1, -1, 1, -1}), "roll");
  EXPECT_EQ(name({1, -1, -1, 1}), "warp");
  EXPECT_EQ(name({1, 0, 0, 0}), std::nullopt);
  EXPECT_EQ(PatternOf({{1, -1}, 0, 0}, std::vector<std::string>{"front", "rear"}), "pitch");
  EXPECT_EQ(PatternOf({{1, -1}, 0, 0}, std::vector<std::string>{"front", "x"}), std::nullopt);
}

}  // namespace
}  // namespace fourpost::stepped_sine_test
