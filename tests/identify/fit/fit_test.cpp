#include "identify/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string_view>

#include <gmock/gmock.h>

#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/four_post/response_misfit.h"
#include "identify/residuals/history_misfit.h"
#include "tests/identify/shipped_study.h"
#include "tests/identify/toy_objective.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::fit_test {
namespace {

/// Parameters away from the file's starting values, inside their ranges.
std::vector<double> Truth(const Vehicle& vehicle) {
  std::vector<double> truth;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const Parameter& p = vehicle.parameters[i];
    const double share = 0.25 + 0.5 * std::fmod(0.37 * static_cast<double>(i + 1), 1.0);
    truth.push_back(p.lower + share * (p.upper - p.lower));
  }
  return truth;
}

/// Relative standard deviation of the twin's recordings.
constexpr double kDeviation = 0.01;

/// Recordings that the study's vehicle makes at these parameters, with `noise` times their deviations.
LoadedStudy Twin(const std::vector<double>& truth, double noise) {
  LoadedStudy study = ShippedStudy();
  // Fewer frequencies: the test has to be quick.
  Sines(study).plan.band_lower_Hz = 0.9;
  // A twin has no model error; its struts drift by a tenth of a millimetre.
  Sines(study).plan.model_error = {.gain_dB = 0, .phase_rad = 0, .mean_m = 0.1e-3};
  const CondensedModel model = CondensedVehicle(study.vehicle).At(truth);
  const auto responses = ModelledResponses(model, study.vehicle.sensors, Sines(study).runs);
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal;
  const auto draw = [&](std::mt19937_64& of) { return noise * normal(of); };
  for (std::size_t r = 0; r < Sines(study).runs.size(); ++r)
    for (MeasuredChannel& channel : Sines(study).runs[r].channels) {
      const ChannelResponse& truth_channel = responses[r].channels[channel.sensor];
      for (std::size_t i = 0; i < channel.response.size(); ++i) {
        const std::complex<double> relative(kDeviation * draw(engine), kDeviation * draw(engine));
        channel.response[i] = truth_channel.response[i] * (1.0 + relative);
        channel.radial_sd[i] = kDeviation * std::abs(channel.response[i]);
        channel.tangential_sd[i] = channel.radial_sd[i];
      }
      for (std::size_t i = 0; i < channel.mean.size(); ++i)
        channel.mean[i] = truth_channel.mean[i] + Sines(study).plan.model_error.mean_m * draw(engine);
    }
  for (MeasuredLoad& load : Rest(study).loads) load.load_N = model.preloads.tyre[load.tyre] + load.sd_N * draw(engine);
  return study;
}

FitOptions Options(int threads = 2) {
  FitOptions options;
  options.search = ThesisDvhde();
  options.stop.max_evaluations = 120;
  options.starts = 1;
  options.threads = threads;
  return options;
}

TEST(Fit, RecoversTheParametersOfATwinWithoutNoise) {
  const std::vector<double> truth = Truth(ShippedStudy().vehicle);
  const LoadedStudy twin = Twin(truth, 0);
  const VehicleObjective objective = twin.MakeObjective();
  const FitResult fit = Fit(objective, Options());
  EXPECT_EQ(fit.end, FitEnd::kConverged) << fit.message;
  ASSERT_EQ(fit.values.size(), truth.size());
  // The refinement stops when the cost, which is zero at the truth, no longer falls: well below a hundredth of the
  // standard deviations, which are some tenths of a percent.
  for (std::size_t i = 0; i < truth.size(); ++i)
    EXPECT_NEAR(fit.values[i] / truth[i], 1, 1e-5) << fit.parameters[i].name;
}

TEST(Fit, RecoversTheParametersOfANoisyTwinWithinTheirDeviations) {
  const std::vector<double> truth = Truth(ShippedStudy().vehicle);
  const LoadedStudy twin = Twin(truth, 1);
  const VehicleObjective objective = twin.MakeObjective();
  const FitResult fit = Fit(objective, Options());
  EXPECT_EQ(fit.covariance.value().rank, static_cast<int>(truth.size()));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    // Four standard deviations: one normal draw in 16 000 lies outside.
    EXPECT_LT(std::abs(fit.values[i] - truth[i]), 4 * fit.parameters[i].sd) << fit.parameters[i].name;
    EXPECT_LT(fit.parameters[i].sd, 0.05 * truth[i]) << fit.parameters[i].name << " is not determined";
    // Of logarithms: a ratio on either side.
    const FittedParameter& p = fit.parameters[i];
    const double reach = fit.covariance->reach_95 * p.sd / p.value;
    EXPECT_NEAR(std::log(p.upper_95 / p.value), reach, 1e-12) << p.name;  // rounding
    EXPECT_NEAR(std::log(p.value / p.lower_95), reach, 1e-12) << p.name;
  }
}

/// Without a force the recordings leave the common scale of all parameters open.
void LeaveOutForces(LoadedStudy& study) {
  Rest(study).loads.clear();
  for (MeasuredRun& run : Sines(study).runs) std::erase_if(run.channels, [](const auto& c) { return c.unit == "N"; });
}

TEST(Fit, APriorOnOneMassDeterminesTheScaleThatAccelerationsLeaveOpen) {
  const std::vector<double> truth = Truth(ShippedStudy().vehicle);
  LoadedStudy twin = Twin(truth, 0);
  LeaveOutForces(twin);
  const VehicleObjective without = twin.MakeObjective();
  const FitResult open = Fit(without, Options());
  EXPECT_EQ(open.covariance.value().rank, static_cast<int>(truth.size()) - 1);
  EXPECT_TRUE(std::isinf(open.parameters[0].sd));
  EXPECT_EQ(open.parameters[0].lower_95, 0);
  EXPECT_TRUE(std::isinf(open.parameters[0].upper_95));
  EXPECT_EQ(open.parameters[0].prior_sd, std::nullopt);
  EXPECT_EQ(open.parameters[0].FromPrior(), 0);

  const Parameter mass = twin.vehicle.parameters[twin.free[0]];
  ASSERT_EQ(mass.name, "m_sprung");
  // So wide that differences of the data alone would hide it.
  const double prior_sd = 0.3 * mass.value;
  twin.vehicle.parameters[twin.free[0]].prior_sd = prior_sd;
  const VehicleObjective with = twin.MakeObjective();
  const FitResult fit = Fit(with, Options());
  EXPECT_EQ(fit.end, FitEnd::kConverged) << fit.message;
  EXPECT_EQ(fit.residual_count, open.residual_count + 1);
  EXPECT_EQ(fit.prior_count, 1);
  EXPECT_EQ(fit.covariance.value().rank, static_cast<int>(truth.size()));
  EXPECT_EQ(fit.parameters[0].prior_sd, prior_sd);
  // All parameters follow the mass, which is all that its prior says of it. The refinement stops as without noise.
  const double scale = mass.value / truth[twin.free[0]];
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(fit.values[i] / (scale * truth[i]), 1, 1e-5) << fit.parameters[i].name;
    EXPECT_TRUE(std::isfinite(fit.parameters[i].sd)) << fit.parameters[i].name;
  }
  EXPECT_NEAR(fit.parameters[0].FromPrior(), 0, 1e-4);
  // Central differences by h = 1e-2 of the logarithm, tied to the balance's accuracy, err by h^2 / 6.
  EXPECT_NEAR(fit.parameters[0].sd / prior_sd, 1, 1.8e-5);
}

TEST(Fit, APriorOnTheOpenScaleDoesNotChangeTheMisfit) {
  LoadedStudy twin = Twin(Truth(ShippedStudy().vehicle), 1);
  LeaveOutForces(twin);
  const auto misfits = [&](const FitResult& fit) {
    const CondensedModel model = CondensedVehicle(twin.vehicle).At(fit.values);
    return ResponseMisfits(Sines(twin).runs, ModelledResponses(model, twin.vehicle.sensors, Sines(twin).runs));
  };
  const VehicleObjective without = twin.MakeObjective();
  const FitResult open = Fit(without, Options());
  twin.vehicle.parameters[twin.free[0]].prior_sd = 1;
  const VehicleObjective with = twin.MakeObjective();
  const FitResult fit = Fit(with, Options());
  // The refinement stops when the cost falls by less than 1e-8 of itself.
  EXPECT_NEAR(fit.cost / open.cost, 1, 1e-6);
  EXPECT_NEAR(fit.parameters[0].FromPrior(), 0, 1e-2);
  const std::vector<ChannelMisfit> known = misfits(fit);
  const std::vector<ChannelMisfit> unknown = misfits(open);
  ASSERT_EQ(known.size(), 9u);
  for (std::size_t i = 0; i < known.size(); ++i) EXPECT_NEAR(known[i].rms_dB / unknown[i].rms_dB, 1, 1e-3);
}

TEST(Fit, WeighsAPriorAgainstTheData) {
  const std::vector<double> truth = Truth(ShippedStudy().vehicle);
  LoadedStudy twin = Twin(truth, 0);
  const VehicleObjective without = twin.MakeObjective();
  const double data_sd = Fit(without, Options()).parameters[0].noise_sd;
  // As good as the data, and as far from the truth as the file's value is.
  twin.vehicle.parameters[twin.free[0]].prior_sd = data_sd;
  const VehicleObjective with = twin.MakeObjective();
  const FitResult fit = Fit(with, Options());
  const double start = twin.vehicle.parameters[twin.free[0]].value;
  const double off = start - truth[twin.free[0]];
  // Halfway, and the inverse variances add up; to first order in `off`, which is 2 % of the mass.
  EXPECT_NEAR((fit.parameters[0].value - truth[twin.free[0]]) / off, 0.5, 0.05);
  EXPECT_NEAR(fit.parameters[0].noise_sd / data_sd, std::sqrt(0.5), 0.05);
  EXPECT_NEAR(fit.parameters[0].FromPrior(), -0.5 * off / data_sd, 0.05 * std::abs(off) / data_sd);
  EXPECT_NEAR(fit.prior_cost, std::pow(fit.parameters[0].FromPrior(), 2), 1e-9 * fit.prior_cost);  // rounding
}

TEST(Fit, IsTheSameForOneAndTwoThreads) {
  const LoadedStudy study = Twin(Truth(ShippedStudy().vehicle), 1);
  const VehicleObjective objective = study.MakeObjective();
  const FitResult one = Fit(objective, Options(1));
  const FitResult two = Fit(objective, Options(2));
  EXPECT_EQ(one.cost, two.cost);
  EXPECT_EQ(one.values, two.values);
  EXPECT_EQ(one.evaluations.paid, two.evaluations.paid);
  EXPECT_EQ(one.evaluations.reused, two.evaluations.reused);
}

TEST(Fit, SaysWhichParametersLieAtTheirBounds) {
  std::vector<double> truth = Truth(ShippedStudy().vehicle);
  LoadedStudy twin = Twin(truth, 0);
  // Bounds that exclude the answer.
  Parameter& mass = twin.vehicle.parameters[twin.free[0]];
  mass.upper = 0.5 * (mass.lower + truth[twin.free[0]]);
  mass.value = mass.lower;
  const VehicleObjective objective = twin.MakeObjective();
  const FitResult fit = Fit(objective, Options());
  EXPECT_TRUE(fit.parameters[0].at_bound);
  EXPECT_EQ(fit.parameters[0].value, mass.upper);
  EXPECT_EQ(fit.parameters[0].BoundName(), "upper");
  // It is known by its bound and not by the data, of which the others' deviations are while it stays there.
  EXPECT_EQ(fit.parameters[0].state, ParameterState::kAtBound);
  for (const double number : {fit.parameters[0].sd, fit.parameters[0].lower_95, fit.parameters[0].upper_95})
    EXPECT_TRUE(std::isnan(number));
  EXPECT_EQ(fit.covariance.value().directions.cols(), 11);
  for (std::size_t i = 1; i < fit.parameters.size(); ++i) {
    EXPECT_EQ(fit.parameters[i].state, ParameterState::kDetermined) << fit.parameters[i].name;
    EXPECT_GT(fit.parameters[i].sd, 0);
  }
}

/// p0 + p1 x with p1 of hardly any effect, between zero and 5, and noise of `scale` deviations.
VehicleObjective Line(double scale) {
  const VehicleObjective toy = ToyObjective(2, 100, 1e-9, {});
  Vehicle vehicle = toy.vehicle();
  vehicle.parameters[1].lower = 0;
  // A file in which p1 is the rate of a spring and p0 a coordinate.
  vehicle.text = R"(<robot xmlns:fp="urn:fourpost:vehicle:1"><fp:spring name="s" parent="a" child="b">
    <linear stiffness="$p1" preload="$p0"/></fp:spring></robot>)";
  ResidualBlock block{.name = "line", .count = 100, .accuracy = 1e-9};
  block.evaluate = [scale](const std::vector<double>& p, const Deadline&) {
    Evaluation evaluation;
    evaluation.residuals.resize(100);
    for (int i = 0; i < 100; ++i) {
      // Most small, some large: a loss bounds the pull of these.
      const double noise = scale * (i % 10 == 0 ? 6 : 0.4) * (i % 20 < 10 ? 1 : -1);
      evaluation.residuals[i] = 10 * (p[0] - 1) + 0.05 * (p[1] - 1) * i / 10.0 + noise;
    }
    return evaluation;
  };
  return {std::move(vehicle), {0, 1}, {std::move(block)}};
}

TEST(Fit, AnIntervalDoesNotReachBeyondWhatIsPhysical) {
  const VehicleObjective objective = Line(1.2);
  const FitResult fit = Fit(objective, Options());
  const FittedParameter& rate = fit.parameters[1];
  // It fills the range between the bounds, which say as much.
  EXPECT_EQ(rate.state, ParameterState::kUndetermined);
  // Beyond the user's bound where that is possible.
  EXPECT_LT(rate.value - fit.covariance->reach_95 * rate.sd, 0);
  EXPECT_EQ(rate.lower_95, 0);
  EXPECT_NEAR(rate.upper_95, rate.value + fit.covariance->reach_95 * rate.sd, 1e-9);  // rounding
  EXPECT_GT(rate.upper_95, rate.upper);
}

TEST(Fit, ALossLeavesDeviationsAsLargeAsTheMisfitSays) {
  const VehicleObjective objective = Line(2);
  const FitResult squares = Fit(objective, Options());
  ASSERT_GT(squares.Misfit(), 2);
  FitOptions options = Options();
  options.refine.loss = RobustLoss(LossKind::kHuber, UsualScale(LossKind::kHuber), 0);
  const FitResult huber = Fit(objective, options);
  EXPECT_GE(huber.covariance->inflation, huber.Misfit() * (1 - 1e-12));  // rounding
  EXPECT_GE(huber.parameters[0].sd, 0.99 * squares.parameters[0].sd);
}

TEST(Fit, TellsTheLowestCostSoFar) {
  const LoadedStudy twin = Twin(Truth(ShippedStudy().vehicle), 1);
  const VehicleObjective objective = twin.MakeObjective();
  // By the loss that is minimised: squares would be more.
  for (const LossKind loss : {LossKind::kNone, LossKind::kHuber}) {
    FitOptions options = Options();
    if (loss != LossKind::kNone) options.refine.loss = RobustLoss(loss, 0.5, objective.prior_count());
    std::vector<double> costs;
    FitHooks hooks;
    hooks.progress = [&](const FitProgress& progress) { costs.push_back(progress.best_cost); };
    const FitResult fit = Fit(objective, options, hooks);
    EXPECT_TRUE(std::is_sorted(costs.rbegin(), costs.rend()));
    EXPECT_LE(costs.back(), fit.cost);
    EXPECT_GT(costs.back(), 0.99 * fit.cost);
  }
}

TEST(Fit, TellsEachEvaluationOfABatch) {
  const LoadedStudy twin = Twin(Truth(ShippedStudy().vehicle), 1);
  const VehicleObjective objective = twin.MakeObjective();
  std::int64_t before = 0;
  std::int64_t largest_step = 0;
  std::set<std::string_view> stages;
  FitHooks hooks;
  hooks.progress = [&](const FitProgress& progress) {
    largest_step = std::max(largest_step, progress.paid - before);
    before = progress.paid;
    stages.insert(progress.stage);
  };
  FitOptions options = Options();
  options.identify_first = true;
  options.refine.differences = Differences::kAutomatic;
  Fit(objective, options, hooks);
  // The model's own derivatives count as one evaluation per parameter, and come with the one that they are taken at.
  EXPECT_LE(largest_step, static_cast<std::int64_t>(twin.free.size()) + 1);
  EXPECT_THAT(stages, testing::IsSupersetOf({"identifiability", "search", "refine", "deviations"}));
}

TEST(Fit, EndsWithWhatItHasWhenAsked) {
  const LoadedStudy twin = Twin(Truth(ShippedStudy().vehicle), 0);
  const VehicleObjective objective = twin.MakeObjective();
  int asked = 0;
  const FitResult fit = Fit(objective, Options(), {.stop = [&] { return ++asked > 3; }});
  EXPECT_EQ(fit.end, FitEnd::kInterrupted);
  EXPECT_EQ(fit.values.size(), twin.vehicle.parameters.size());
  EXPECT_GT(fit.cost, 0);
  EXPECT_FALSE(fit.covariance.has_value());
  EXPECT_TRUE(std::isnan(fit.parameters[0].sd));
  EXPECT_EQ(fit.residual_count, objective.residual_count());
}

TEST(Fit, EndsWithinABatchOfDifferences) {
  const LoadedStudy twin = Twin(Truth(ShippedStudy().vehicle), 1);
  const VehicleObjective objective = twin.MakeObjective();
  FitOptions options = Options();
  options.identify_first = true;
  const auto ended_in = [&](std::string_view stage, Differences differences) {
    options.refine.differences = differences;
    bool asked = false;
    std::int64_t since = 0;
    FitHooks hooks;
    hooks.progress = [&](const FitProgress& progress) {
      asked = asked || (progress.stage == stage && progress.in_stage > 1);
      since += asked;
    };
    hooks.stop = [&] { return asked; };
    FitResult fit = Fit(objective, options, hooks);
    // A batch has two evaluations for each parameter.
    EXPECT_LT(since, static_cast<std::int64_t>(twin.free.size())) << stage;
    EXPECT_EQ(fit.end, FitEnd::kInterrupted) << stage;
    return fit;
  };
  EXPECT_TRUE(ended_in("identifiability", Differences::kCentral).parameters.empty());
  const FitResult refined = ended_in("deviations", Differences::kAutomatic);
  EXPECT_LT(refined.cost, 1.1 * static_cast<double>(refined.residual_count));
  // Held parameters and noise of inputs would not be in it.
  EXPECT_FALSE(refined.covariance.has_value());
}

TEST(Fit, CostsTheLossWhereNothingWasRefined) {
  const LoadedStudy twin = Twin(Truth(ShippedStudy().vehicle), 0);
  const VehicleObjective objective = twin.MakeObjective();
  FitOptions options = Options();
  options.refine.loss = RobustLoss(LossKind::kHuber, 2, objective.prior_count());
  int asked = 0;
  const FitResult fit = Fit(objective, options, {.stop = [&] { return ++asked > 3; }});
  ASSERT_EQ(fit.end, FitEnd::kInterrupted);
  ASSERT_EQ(fit.starts, 0);
  const Candidate& best = fit.search.candidates.front();
  EXPECT_EQ(fit.cost, options.refine.loss.Cost(objective.Evaluate(best.values).residuals));
  EXPECT_LT(fit.cost, best.cost);
}

TEST(Fit, TellsWhenEveryEvaluationFails) {
  LoadedStudy study = ShippedStudy();
  for (MeasuredRun& run : Sines(study).runs)
    run.excitation.amplitude_m.assign(run.excitation.amplitude_m.size(), 1e308);
  const VehicleObjective objective = study.MakeObjective();
  const FitResult fit = Fit(objective, Options());
  EXPECT_EQ(fit.end, FitEnd::kAllFailed);
  EXPECT_THAT(fit.message, testing::HasSubstr("every evaluation failed"));
}

}  // namespace
}  // namespace fourpost::fit_test
