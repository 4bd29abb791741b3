#include "identify/residuals/vehicle_objective.h"

#include <cmath>

#include <gmock/gmock.h>

#include "analysis/signals/decibel.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "tests/identify/shipped_study.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::four_post_residuals_test {
namespace {

/// The study's vehicle and channels, with recordings that the vehicle itself would make at these parameters.
LoadedStudy Twin(const std::vector<double>& parameters) {
  LoadedStudy study = ShippedStudy();
  const CondensedModel model = CondensedVehicle(study.vehicle).At(parameters);
  const auto responses = ModelledResponses(model, study.vehicle.sensors, Sines(study).runs);
  for (std::size_t r = 0; r < Sines(study).runs.size(); ++r)
    for (MeasuredChannel& channel : Sines(study).runs[r].channels) {
      channel.response = responses[r].channels[channel.sensor].response;
      if (!channel.mean.empty()) channel.mean = responses[r].channels[channel.sensor].mean;
      if (!channel.second_harmonic.empty())
        channel.second_harmonic = responses[r].channels[channel.sensor].second_harmonic;
    }
  for (MeasuredLoad& load : Rest(study).loads) load.load_N = model.preloads.tyre[load.tyre];
  return study;
}

Eigen::VectorXd FreeValues(const VehicleObjective& objective) {
  const std::vector<double> all = objective.vehicle().ParameterValues();
  Eigen::VectorXd values(static_cast<Eigen::Index>(objective.free().size()));
  for (std::size_t i = 0; i < objective.free().size(); ++i)
    values[static_cast<Eigen::Index>(i)] = all[objective.free()[i]];
  return values;
}

TEST(FourPostResiduals, IsZeroForTheVehicleThatMadeTheData) {
  const LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  const VehicleObjective objective = study.MakeObjective();
  const Evaluation evaluation = objective.Evaluate(FreeValues(objective));
  ASSERT_TRUE(evaluation.ok()) << evaluation.detail;
  EXPECT_GT(evaluation.residuals.size(), 1000);
  EXPECT_LT(evaluation.residuals.cwiseAbs().maxCoeff(), 1e-9);  // rounding over standard deviations of 1e-2
}

/// Of a run with means and no second harmonics, in the order of the residuals.
std::vector<Eigen::Index> PlacesOfEveryFourth(const std::vector<MeasuredRun>& runs) {
  std::vector<Eigen::Index> places;
  Eigen::Index next = 0;
  for (const MeasuredRun& run : runs)
    for (const MeasuredChannel& channel : run.channels)
      for (const auto& [count, each] : {std::pair{channel.response.size(), 2}, std::pair{channel.mean.size(), 1}})
        for (std::size_t i = 0; i < count; ++i)
          for (int part = 0; part < each; ++part, ++next)
            if (i % 4 == 0) places.push_back(next);
  return places;
}

// Every fourth frequency, with the residuals that it has among all.
TEST(FourPostResiduals, HaveCoarseOnesAmongThem) {
  LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  Sines(study).plan.model_error.second_harmonic_m = 0;
  const std::vector<MeasuredRun> runs = Sines(study).RunsInBand();
  ASSERT_GE(runs.front().excitation.frequency_Hz.size(), 48u);
  const VehicleObjective objective = study.MakeObjective();
  const std::optional<VehicleObjective> coarse = objective.Coarse();
  ASSERT_TRUE(coarse);
  const Eigen::VectorXd elsewhere = 1.05 * FreeValues(objective);
  const Eigen::VectorXd all = objective.Evaluate(elsewhere).residuals;
  const Eigen::VectorXd some = coarse->Evaluate(elsewhere).residuals;
  const std::vector<Eigen::Index> places = PlacesOfEveryFourth(runs);
  ASSERT_GT(some.size(), std::ssize(places));  // loads at rest follow
  // A frequency's motion is solved from that of the one before: to the balance's tolerance of 1e-6 of a response.
  const double tolerance = 1e-4 * all.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < places.size(); ++i)
    ASSERT_NEAR(some[static_cast<Eigen::Index>(i)], all[places[i]], tolerance) << i;
  EXPECT_FALSE(coarse->Coarse());
}

TEST(FourPostResiduals, HaveCoarseOnesWhereFrequenciesAreToSpare) {
  for (const std::size_t count : {47u, 48u}) {
    LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
    Sines(study).plan.band_lower_Hz = 0;
    Sines(study).plan.band_upper_Hz = 1e3;
    for (MeasuredRun& run : Sines(study).runs) {
      std::vector<bool> keep(run.excitation.frequency_Hz.size());
      for (std::size_t i = 0; i < count; ++i) keep[i] = true;
      run = AtFrequencies(run, keep);
    }
    EXPECT_EQ(study.MakeObjective().Coarse().has_value(), count == 48) << count;
  }
}

// A model error of one decibel, or five degrees, is worth one unit.
TEST(FourPostResiduals, WeighsGainAndPhaseByTheModelError) {
  LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  Sines(study).plan.model_error = {.gain_dB = 1, .phase_rad = RadiansFromDegrees(5), .floor = 0};
  const double high = GainFromDecibel(1);
  for (MeasuredRun& run : Sines(study).runs)
    for (MeasuredChannel& channel : run.channels) {
      // The model lies one decibel above, and to first order five degrees ahead of, what is measured now.
      for (std::complex<double>& value : channel.response) value /= std::complex<double>(high, RadiansFromDegrees(5));
      channel.radial_sd.assign(channel.response.size(), 0);
      channel.tangential_sd.assign(channel.response.size(), 0);
      channel.mean.clear();
    }
  Rest(study).loads.clear();
  const VehicleObjective objective = study.MakeObjective();
  const Evaluation evaluation = objective.Evaluate(FreeValues(objective));
  ASSERT_TRUE(evaluation.ok());
  for (const double residual : evaluation.residuals) EXPECT_NEAR(residual, 1, 1e-9);  // rounding
}

// Gains and phases change by 0.2 dB when bump and rebound are swapped, second harmonics not at all: both at once, with
// the means' sign, tell them apart. The struts' second harmonics are half a millimetre off here.
TEST(FourPostResiduals, TakesSecondHarmonicsOfStrutsWhereAsked) {
  LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  Sines(study).plan.model_error.second_harmonic_m = 0;
  const Eigen::Index without = study.MakeObjective().residual_count();
  Sines(study).plan.model_error.second_harmonic_m = 0.1e-3;
  for (MeasuredRun& run : Sines(study).runs)
    for (MeasuredChannel& channel : run.channels)
      for (double& amplitude : channel.second_harmonic) amplitude += 0.5e-3;
  const VehicleObjective objective = study.MakeObjective();
  const Evaluation evaluation = objective.Evaluate(FreeValues(objective));
  ASSERT_TRUE(evaluation.ok());
  const Eigen::Index added = objective.residual_count() - without;
  EXPECT_GT(added, 100);
  EXPECT_EQ(((evaluation.residuals.array() + 5).abs() < 1e-9).count(), added);  // rounding
}

TEST(FourPostResiduals, WeighsMeansByTheirDeviationAndTheModelError) {
  LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  Sines(study).plan.model_error.mean_m = 0.3e-3;
  std::size_t means = 0;
  for (MeasuredRun& run : Sines(study).runs)
    for (MeasuredChannel& channel : run.channels) {
      for (double& mean : channel.mean) mean += 0.5e-3;
      channel.mean_sd.assign(channel.mean.size(), 0.4e-3);
    }
  for (const MeasuredRun& run : Sines(study).RunsInBand())
    for (const MeasuredChannel& channel : run.channels) means += channel.mean.size();
  const VehicleObjective objective = study.MakeObjective();
  const Evaluation evaluation = objective.Evaluate(FreeValues(objective));
  ASSERT_TRUE(evaluation.ok());
  EXPECT_GT(means, 50U);
  EXPECT_EQ(((evaluation.residuals.array() + 1).abs() < 1e-9).count(), static_cast<Eigen::Index>(means));  // rounding
}

/// What one standard deviation of one calibration changes in all residuals, at the file's values.
Eigen::VectorXd ByCalibration(const LoadedStudy& study, const Calibration& calibration) {
  LoadedStudy calibrated = study;
  calibrated.study.calibrations = {calibration};
  const VehicleObjective objective = calibrated.MakeObjective();
  Eigen::VectorXd changes(objective.residual_count());
  Eigen::Index at = 0;
  for (const ResidualBlock& block : objective.blocks()) {
    changes.segment(at, block.count) = block.by_calibrations(objective.vehicle().ParameterValues()).col(0);
    at += block.count;
  }
  return changes.head(at);
}

/// The residuals of a twin whose recordings are those of instruments that read too little: `scale` and `turn` of each
/// response, `level` of means and loads.
Eigen::VectorXd ResidualsOfRead(LoadedStudy study, double scale, double delay_s, double post_scale) {
  for (MeasuredRun& run : Sines(study).runs) {
    for (double& amplitude : run.excitation.amplitude_m) amplitude *= post_scale;
    for (MeasuredChannel& channel : run.channels) {
      for (std::size_t i = 0; i < channel.response.size(); ++i)
        channel.response[i] *= std::polar(scale, -2 * 3.14159265358979 * run.excitation.frequency_Hz[i] * delay_s);
      for (double& mean : channel.mean) mean *= scale;
      for (double& second : channel.second_harmonic) second *= scale;
    }
  }
  const VehicleObjective objective = study.MakeObjective();
  const Evaluation evaluation = objective.Evaluate(FreeValues(objective));
  return evaluation.residuals.head(objective.residual_count() - objective.prior_count());
}

// To first order what a calibration changes is what instruments that read otherwise change, the other way round. Of a
// thousandth the second order is another thousandth.
TEST(FourPostResiduals, ChangeByCalibrationsAsByInstruments) {
  LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  // The scale of residuals follows what is measured; without floors only that of their standard deviations does not.
  Sines(study).plan.model_error.floor = 0;
  Rest(study).loads.clear();
  for (const char* of : {"accelerometers", "struts", "load_cells"}) {
    const Eigen::VectorXd change = ByCalibration(study, {.of = of, .sd = 1e-3});
    EXPECT_GT(change.norm(), 0) << of;
  }
  Eigen::VectorXd sum = ByCalibration(study, {.of = "accelerometers", .sd = 1e-3});
  for (const char* of : {"displacements", "struts", "load_cells", "gyros"})
    sum += ByCalibration(study, {.of = of, .sd = 1e-3});
  const Eigen::VectorXd gain = -ResidualsOfRead(study, 1 + 1e-3, 0, 1);
  EXPECT_LT((sum - gain).norm(), 5e-3 * gain.norm());

  Eigen::VectorXd late = ByCalibration(study, {.kind = Calibration::Kind::kDelay, .of = "accelerometers", .sd = 1e-6});
  for (const char* of : {"displacements", "struts", "load_cells", "gyros"})
    late += ByCalibration(study, {.kind = Calibration::Kind::kDelay, .of = of, .sd = 1e-6});
  const Eigen::VectorXd delayed = -ResidualsOfRead(study, 1, 1e-6, 1);
  EXPECT_LT((late - delayed).norm(), 5e-3 * delayed.norm());
  // All channels late is the posts early.
  const Eigen::VectorXd posts =
      ByCalibration(study, {.kind = Calibration::Kind::kDelay, .of = Calibration::kPosts, .sd = 1e-6});
  EXPECT_LT((late + posts).norm(), 1e-9 * posts.norm());
}

TEST(FourPostResiduals, ChangeByTheGainOfPosts) {
  const LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  const Eigen::VectorXd change = ByCalibration(study, {.of = Calibration::kPosts, .sd = 1e-3});
  // The rig moved by a thousandth more than recorded: responses to what was recorded are larger by as much, and those
  // of dampers that do not depend on amplitude by nothing else.
  EXPECT_GT(change.norm(), 0);
  Eigen::VectorXd all = ByCalibration(study, {.of = "accelerometers", .sd = 1e-3});
  for (const char* of : {"struts", "load_cells"}) all += ByCalibration(study, {.of = of, .sd = 1e-3});
  EXPECT_LT((change - all).norm(), 0.05 * change.norm());  // amplitude counts in bump and rebound by geometry alone
}

TEST(FourPostResiduals, ChangeByCalibrationsOfLoads) {
  const LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  const std::vector<MeasuredLoad>& loads = Rest(study).loads;
  const auto gain = ByCalibration(study, {.of = Calibration::kStaticLoads, .sd = 0.01}).tail(2).eval();
  const auto offset =
      ByCalibration(study, {.kind = Calibration::Kind::kOffset, .of = Calibration::kStaticLoads, .sd = 30})
          .tail(2)
          .eval();
  for (const Eigen::Index i : {0, 1}) {
    const MeasuredLoad& load = loads[static_cast<std::size_t>(i)];
    EXPECT_NEAR(gain[i], 0.01 * load.load_N / load.sd_N, 1e-9 * gain[i]);
    EXPECT_NEAR(offset[i], 30 / load.sd_N, 1e-12);
  }
}

TEST(FourPostResiduals, WeighsStaticLoadsByTheirDeviation) {
  LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  ASSERT_EQ(Rest(study).loads.size(), 2u);
  for (MeasuredLoad& load : Rest(study).loads) load.load_N -= 2 * load.sd_N;
  const VehicleObjective objective = study.MakeObjective();
  const Evaluation evaluation = objective.Evaluate(FreeValues(objective));
  EXPECT_NEAR(evaluation.residuals.tail(2).minCoeff(), 2, 1e-9);  // rounding of 10 kN over 28 N
  EXPECT_NEAR(evaluation.residuals.tail(2).maxCoeff(), 2, 1e-9);
}

TEST(FourPostResiduals, EndsWithOneResidualPerPriorOfAFreeParameter) {
  LoadedStudy study = Twin(ShippedStudy().vehicle.ParameterValues());
  const VehicleObjective without = study.MakeObjective();
  study.vehicle.parameters[study.free[1]].prior_sd = 200;
  study.vehicle.parameters[study.free[3]].prior_sd = 50;
  // Held: it cannot depart from what is known of it.
  study.vehicle.parameters[study.free.back()].prior_sd = 1;
  study.free.pop_back();
  const VehicleObjective with = study.MakeObjective();
  EXPECT_EQ(without.prior_count(), 0);
  EXPECT_EQ(with.prior_count(), 2);
  EXPECT_EQ(with.residual_count(), without.residual_count() + 2);

  Eigen::VectorXd values = FreeValues(with);
  values[1] += 300;
  values[3] -= 5;
  const Evaluation evaluation = with.Evaluate(values);
  ASSERT_TRUE(evaluation.ok()) << evaluation.detail;
  const Eigen::VectorXd priors = evaluation.residuals.tail(2);
  EXPECT_EQ(priors, Eigen::Vector2d(1.5, -0.1));
  EXPECT_EQ(priors, with.PriorResiduals(values));
  Eigen::VectorXd all_values = FreeValues(without);
  all_values.head(values.size()) = values;
  EXPECT_EQ(evaluation.residuals.head(without.residual_count()), without.Evaluate(all_values).residuals);
}

TEST(FourPostResiduals, RefusesAPriorWithoutDeviation) {
  LoadedStudy study = ShippedStudy();
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    study.vehicle.parameters[study.free[0]].prior_sd = bad;
    EXPECT_THAT([&] { study.MakeObjective(); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("prior_sd of m_sprung = ")));
  }
}

// The balance's own derivatives, and those of loads and priors, against central differences.
TEST(FourPostResiduals, DifferentiatesItself) {
  LoadedStudy study = ShippedStudy();
  ASSERT_GT(Sines(study).plan.model_error.second_harmonic_m, 0);
  study.vehicle.parameters[study.free[1]].prior_sd = 200;
  const VehicleObjective objective = study.MakeObjective();
  const Eigen::VectorXd values = FreeValues(objective);
  const Eigen::MatrixXd jacobian = objective.Jacobian(values);
  ASSERT_EQ(jacobian.rows(), objective.residual_count());
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    const double step = 1e-3 * values[j];
    Eigen::VectorXd above = values;
    Eigen::VectorXd below = values;
    above[j] += step;
    below[j] -= step;
    const Eigen::VectorXd column =
        (objective.Evaluate(above).residuals - objective.Evaluate(below).residuals) / (2 * step);
    // As good as the balance tells its sensitivities to be; see balance_sensitivity.h.
    EXPECT_LT((jacobian.col(j) - column).norm(), 1e-2 * column.norm()) << j;
    // Loads and the prior are exact but for rounding over the step.
    EXPECT_LT((jacobian.col(j) - column).tail(3).norm(), 1e-6 * (1e-6 + column.norm())) << j;
  }
}

TEST(FourPostResiduals, EndsAtItsDeadline) {
  const VehicleObjective objective = ShippedStudy().MakeObjective();
  Problem problem = objective.MakeProblem();
  const Eigen::VectorXd values = problem.lattice.Values(LatticePoint(problem.lattice.size(), 2));
  problem.deadline_s = 1e-6;
  EXPECT_EQ(EvaluateGuarded(problem, values).failure, Failure::kTimedOut);
  problem.deadline_s = 60;
  EXPECT_TRUE(EvaluateGuarded(problem, values).ok());
}

// Specification section 5: without a force, masses, rates and dampings may all be scaled alike.
TEST(FourPostResiduals, OnlyForcesPinTheScale) {
  const LoadedStudy twin = Twin(ShippedStudy().vehicle.ParameterValues());
  const VehicleObjective with_forces = twin.MakeObjective();
  LoadedStudy motions = twin;
  Rest(motions).loads.clear();
  for (MeasuredRun& run : Sines(motions).runs) std::erase_if(run.channels, [](const auto& c) { return c.unit == "N"; });
  const VehicleObjective without_forces = motions.MakeObjective();
  const Eigen::VectorXd scaled = 1.05 * FreeValues(with_forces);
  EXPECT_LT(without_forces.Evaluate(scaled).residuals.cwiseAbs().maxCoeff(), 1e-6);  // rounding
  EXPECT_GT(with_forces.Evaluate(scaled).residuals.cwiseAbs().maxCoeff(), 1);
}

}  // namespace
}  // namespace fourpost::four_post_residuals_test
