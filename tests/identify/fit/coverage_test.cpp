// Whether intervals of 95 % hold the truth in 95 % of fits: a twin of Model 1 on the frequencies of its recordings,
// with noise of known deviation, fitted anew for each of 500 noises.
#include <algorithm>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/fit/fit.h"
#include "tests/identify/shipped_study.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::coverage_test {
namespace {

constexpr int kFits = 500;
/// Along each phasor and across it, as a share of the gain and of the channel's largest gain: next to a node noise does
/// not vanish.
constexpr double kDeviation = 0.01;
constexpr double kFloor = 0.003;

LoadedStudy WithoutModelError() {
  LoadedStudy study = ShippedStudy("model1");
  // A third of the frequencies: the test has to be quick.
  Sines(study).plan.band_lower_Hz = 3;
  Sines(study).plan.model_error = {.gain_dB = 0, .phase_rad = 0, .mean_m = 0.1e-3, .floor = 0};
  return study;
}

double Largest(const ChannelResponse& channel) {
  double largest = 0;
  for (const std::complex<double>& response : channel.response) largest = std::max(largest, std::abs(response));
  return largest;
}

/// What the study's vehicle would be measured to do, the file's values being the truth.
void Measure(LoadedStudy& study, const CondensedModel& truth, std::uint64_t noise) {
  RandomStream draws(noise, "coverage");
  const auto responses = ModelledResponses(truth, study.vehicle.sensors, Sines(study).runs);
  for (std::size_t r = 0; r < Sines(study).runs.size(); ++r)
    for (MeasuredChannel& channel : Sines(study).runs[r].channels) {
      const ChannelResponse& modelled = responses[r].channels[channel.sensor];
      const double largest = Largest(modelled);
      for (std::size_t i = 0; i < channel.response.size(); ++i) {
        const double sd = std::hypot(kDeviation * std::abs(modelled.response[i]), kFloor * largest);
        channel.response[i] = modelled.response[i] + std::complex<double>(sd * draws.Normal(), sd * draws.Normal());
        channel.radial_sd[i] = channel.tangential_sd[i] = sd;
      }
      for (std::size_t i = 0; i < channel.mean.size(); ++i)
        channel.mean[i] = modelled.mean[i] + Sines(study).plan.model_error.mean_m * draws.Normal();
    }
  for (MeasuredLoad& load : Rest(study).loads)
    load.load_N = truth.preloads.tyre[load.tyre] + load.sd_N * draws.Normal();
}

/// From the file's values, without a search.
FitOptions Quick(const VehicleObjective& objective) {
  FitOptions options;
  options.from = objective.FileValues();
  options.refine.differences = Differences::kAutomatic;
  return options;
}

TEST(Coverage, OfNominal95PercentIsThat) {
  LoadedStudy study = WithoutModelError();
  const CondensedModel truth = CondensedVehicle(study.vehicle).At(study.vehicle.ParameterValues());
  std::vector<int> covered(study.free.size(), 0);
  double standardised = 0;
  for (int k = 0; k < kFits; ++k) {
    Measure(study, truth, static_cast<std::uint64_t>(k));
    const VehicleObjective objective = study.MakeObjective();
    const FitResult fit = Fit(objective, Quick(objective));
    ASSERT_EQ(fit.end, FitEnd::kConverged) << k << ": " << fit.message;
    for (std::size_t p = 0; p < covered.size(); ++p) {
      const FittedParameter& fitted = fit.parameters[p];
      covered[p] += fitted.start >= fitted.lower_95 && fitted.start <= fitted.upper_95;
      standardised += std::pow((fitted.value - fitted.start) / fitted.sd, 2);
    }
  }
  const auto fits = static_cast<double>(kFits);
  double all = 0;
  for (std::size_t p = 0; p < covered.size(); ++p) {
    const double share = covered[p] / fits;
    all += share / static_cast<double>(covered.size());
    RecordProperty(study.vehicle.parameters[study.free[p]].name, std::to_string(100 * share));
    // A true 95 % would be found within 2.5 % in 99 of 100 such tests of a parameter.
    EXPECT_GE(share, 0.925) << study.vehicle.parameters[study.free[p]].name;
    EXPECT_LE(share, 0.975) << study.vehicle.parameters[study.free[p]].name;
  }
  EXPECT_NEAR(all, 0.95, 0.01);
  // The scatter of the estimates over the deviations told.
  EXPECT_NEAR(std::sqrt(standardised / (fits * static_cast<double>(covered.size()))), 1, 0.05);
}

}  // namespace
}  // namespace fourpost::coverage_test
