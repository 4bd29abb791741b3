#include "identify/experiments/bench/bench_bands.h"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/identify/shipped_study.h"

namespace fourpost::bench_bands_test {
namespace {

/// The shipped sweep, and the linear damper of Model 1.
LoadedStudy LinearDamper() {
  Diagnostics diagnostics;
  return *LoadStudy(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/damper/model1.yaml", diagnostics);
}

ParameterSpread KnownTo(double relative_sd, double value) {
  return {.lattice = Lattice({{"c", 100, 8000, 1}}),
          .values = Eigen::VectorXd::Constant(1, value),
          .judged = {0},
          .noise = Eigen::MatrixXd::Constant(1, 1, relative_sd * relative_sd),
          .total = Eigen::MatrixXd::Constant(1, 1, relative_sd * relative_sd)};
}

// The force of a linear damper is c v: d force / d ln c is the force itself.
TEST(BenchBands, AreAsWideAsALinearForceIsUncertain) {
  const LoadedStudy study = LinearDamper();
  const BenchDamper damper(study.vehicle, 0);
  const std::vector<double> values = study.vehicle.ParameterValues();
  ASSERT_EQ(values.size(), 1U);
  const ModelledRecording modelled = Modelled(damper, Bench(study).data.fitted.front(), values);
  constexpr double kSd = 0.05;
  constexpr double kMissed = 0.3;
  ParameterSpread spread = KnownTo(kSd, values[0]);
  spread.lattice = Lattice({{study.vehicle.parameters[0].name, 100, 8000, 1}});
  const std::optional<BenchBands> bands = BandsOfForce(damper, modelled, study.vehicle, spread, kMissed);
  ASSERT_TRUE(bands);
  const BenchRecording& recording = modelled.recording;
  ASSERT_EQ(bands->about.parameters.size(), static_cast<Eigen::Index>(recording.end - recording.first));
  double squares = 0;
  for (std::size_t k = recording.first; k < recording.end; ++k) squares += std::pow(modelled.force[k], 2);
  const double rms = std::sqrt(squares / static_cast<double>(recording.end - recording.first));
  for (Eigen::Index i = 0; i < bands->about.parameters.size(); i += 100) {
    const double by_parameters =
        1.959964 * kSd * std::abs(modelled.force[recording.first + static_cast<std::size_t>(i)]);
    // Central differences of an exponential over a tenth of its deviation: (0.005)^2 / 6.
    EXPECT_NEAR(bands->about.parameters[i], by_parameters, 1e-5 * by_parameters + 1e-6);
    EXPECT_NEAR(bands->about.measured[i], std::hypot(by_parameters, kMissed * rms), 1e-5 * rms);
  }
  EXPECT_EQ(bands->count.points, bands->about.measured.size());
  EXPECT_EQ(bands->evaluations, 2);
}

TEST(BenchBands, DiscrepancyIsWhatNineteenOfTwentyErrorsStayBelow) {
  const LoadedStudy study = LinearDamper();
  ModelledRecording modelled =
      Modelled(BenchDamper(study.vehicle, 0), Bench(study).data.fitted.front(), study.vehicle.ParameterValues());
  BenchRecording& recording = modelled.recording;
  const auto count = static_cast<double>(recording.end - recording.first);
  double squares = 0;
  for (std::size_t k = recording.first; k < recording.end; ++k) squares += std::pow(modelled.force[k], 2);
  for (std::size_t k = recording.first; k < recording.end; ++k)
    recording.force[k] = modelled.force[k] + static_cast<double>(k - recording.first) / count;
  EXPECT_NEAR(ForceDiscrepancy({modelled}) * std::sqrt(squares / count), 0.95, 2 / count);
}

}  // namespace
}  // namespace fourpost::bench_bands_test
