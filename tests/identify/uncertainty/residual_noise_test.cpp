#include "identify/uncertainty/residual_noise.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::residual_noise_test {
namespace {

constexpr Eigen::Index kSamples = 20000;

Eigen::VectorXd White(std::uint64_t seed) {
  RandomStream draws(seed, "noise");
  Eigen::VectorXd noise(kSamples);
  for (double& value : noise) value = draws.Normal();
  return noise;
}

Eigen::VectorXd Correlated(double correlation, std::uint64_t seed) {
  Eigen::VectorXd noise = White(seed);
  for (Eigen::Index k = 1; k < kSamples; ++k) noise[k] += correlation * noise[k - 1];
  return noise;
}

ResidualStructure OverTime(Eigen::Index channels) {
  ResidualStructure structure;
  for (Eigen::Index c = 0; c < channels; ++c)
    structure.series.push_back(
        {.first = c * kSamples, .count = kSamples, .step = 1, .is_over_time = true, .record = 0});
  return structure;
}

Eigen::MatrixXd NothingFitted(Eigen::Index residuals) { return Eigen::MatrixXd::Zero(residuals, 1); }

// x_t = a x_{t-1} + e_t: the sum over all samples has the variance N / (1 - a)^2, a slow sine of it the same times a
// half, and one at half the rate N / (1 + a)^2.
TEST(ResidualNoise, KnowsHowFarCorrelatedNoiseMovesSums) {
  constexpr double kCorrelation = 0.9;
  Eigen::MatrixXd jacobian(kSamples, 2);
  for (Eigen::Index k = 0; k < kSamples; ++k) jacobian.row(k) << 1, (k % 2 == 0 ? 1 : -1);
  constexpr std::uint64_t kDraws = 20;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(2, 2);
  for (std::uint64_t draw = 0; draw < kDraws; ++draw)
    covariance += ResidualNoise(Correlated(kCorrelation, draw), OverTime(1), NothingFitted(kSamples))
                      .CovarianceOverTime(jacobian) /
                  kDraws;
  // The spectrum's own scatter at one frequency, of eight independent points in each draw: 8 %; three times that.
  EXPECT_NEAR(covariance(0, 0) / (kSamples / std::pow(1 - kCorrelation, 2)), 1, 0.24);
  EXPECT_NEAR(covariance(1, 1) / (kSamples / std::pow(1 + kCorrelation, 2)), 1, 0.24);
}

// What was not measured has neither noise nor derivatives: the rest is worth what it is alone.
TEST(ResidualNoise, IsThatOfTheSamplesThatWereMeasured) {
  Eigen::VectorXd noise = White(5);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Ones(kSamples, 1);
  for (Eigen::Index k = 0; k < kSamples; k += 2) jacobian(k, 0) = -1;
  ResidualStructure structure = OverTime(1);
  structure.series[0].unmeasured = 8000;
  noise.segment(3000, 8000).setZero();
  jacobian.middleRows(3000, 8000).setZero();
  const double covariance = ResidualNoise(noise, structure, NothingFitted(kSamples)).CovarianceOverTime(jacobian)(0, 0);
  // The spectrum is a mean of some 40 independent points on each side: 11 %; three times that.
  EXPECT_NEAR(covariance / 12000, 1, 0.33);
}

TEST(ResidualNoise, SeesNoiseThatChannelsHaveInCommon) {
  const Eigen::VectorXd common = White(2);
  Eigen::VectorXd residuals(2 * kSamples);
  residuals << common, -common;
  const ResidualNoise judged(residuals, OverTime(2), NothingFitted(2 * kSamples));
  // Equal derivatives of both channels: their noise cancels.
  const Eigen::MatrixXd covariance = judged.CovarianceOverTime(Eigen::MatrixXd::Ones(2 * kSamples, 1));
  EXPECT_LT(covariance(0, 0), 1e-6 * kSamples);
}

// A narrow band of a short record, most of whose noise a fit of twelve columns takes with it: what is left says a third
// to a half too little, and leverage makes up for it.
TEST(ResidualNoise, MakesUpForWhatAFitTakesWithIt) {
  constexpr Eigen::Index kCount = 600;
  constexpr Eigen::Index kColumns = 12;
  Eigen::MatrixXd jacobian(kCount, kColumns);
  for (Eigen::Index k = 0; k < kCount; ++k)
    for (Eigen::Index p = 0; p < kColumns; ++p) {
      const double turns = static_cast<double>(30 + p / 2) * static_cast<double>(k) / kCount;
      jacobian(k, p) = std::cos(2 * std::numbers::pi * (turns - 0.25 * static_cast<double>(p % 2)));
    }
  ResidualStructure structure;
  structure.series = {{.first = 0, .count = kCount, .step = 1, .is_over_time = true, .record = 0}};
  double left = 0;
  double made_up = 0;
  constexpr int kDraws = 40;
  for (int draw = 0; draw < kDraws; ++draw) {
    const Eigen::VectorXd noise = White(static_cast<std::uint64_t>(100 + draw)).head(kCount);
    const Eigen::VectorXd residuals = noise - jacobian * (jacobian.transpose() * noise) * (2.0 / kCount);
    const auto trace = [&](const Eigen::MatrixXd& fitted) {
      return ResidualNoise(residuals, structure, fitted).CovarianceOverTime(jacobian).trace() / kDraws;
    };
    left += trace(NothingFitted(kCount));
    made_up += trace(jacobian);
  }
  // Of white noise of deviation 1 the trace is that of J' J. Smoothing spreads both the band and what is left of it.
  const double truth = 0.5 * kCount * kColumns;
  EXPECT_LT(left, 0.75 * truth);
  EXPECT_NEAR(made_up / truth, 1, 0.1);
}

TEST(ResidualNoise, TakesOnlyWhatIsRoughForNoiseOverFrequency) {
  constexpr Eigen::Index kCount = 200;
  const Eigen::VectorXd rough = 0.1 * White(3).head(kCount);
  Eigen::VectorXd residuals(kCount);
  for (Eigen::Index k = 0; k < kCount; ++k) residuals[k] = 5 * std::sin(0.02 * static_cast<double>(k)) + rough[k];
  ResidualStructure structure;
  structure.series = {{.first = 0, .count = kCount, .step = 1}};
  const ResidualNoise judged(residuals, structure, NothingFitted(kCount));
  const std::vector<char> all(kCount, 1);
  const Eigen::MatrixXd covariance = judged.CovarianceOfScores(Eigen::MatrixXd::Ones(kCount, 1), all, all);
  // Of 200 variances by second differences, which are correlated: 15 %, twice.
  EXPECT_NEAR(covariance(0, 0) / (0.01 * kCount), 1, 0.3);
}

}  // namespace
}  // namespace fourpost::residual_noise_test
