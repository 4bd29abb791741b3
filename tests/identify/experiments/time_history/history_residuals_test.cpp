#include "identify/experiments/time_history/history_residuals.h"

#include <cmath>
#include <memory>
#include <numeric>

#include <gmock/gmock.h>

#include "analysis/signals/drift.h"
#include "analysis/signals/random_stream.h"
#include "identify/experiments/time_history/history_block.h"
#include "identify/experiments/time_history/history_misfits.h"
#include "tests/identify/recorded_station.h"
#include "tests/temporary_folder.h"

namespace fourpost::history_residuals_test {
namespace {

constexpr LowPassDesign kFilter{.order = 4, .cutoff_Hz = 30};

/// The station with friction, which sees amplitudes.
Vehicle RubbingStation() {
  Vehicle vehicle = ShippedVehicle("single_wheel_station");
  vehicle.dampers[0].law.friction = DashpotDescription::Friction{.force = {40}, .speed = {0.005}};
  return vehicle;
}

class HistoryResidualsTest : public testing::Test {
 protected:
  /// What was recorded of the vehicle; `filter`: what the study says of it.
  std::vector<MeasuredHistory> Recording(std::optional<LowPassDesign> filter = kFilter) {
    StudyHistory study{.name = "sweep", .posts = {{"ground", {.channels = {"z_ground"}}}}, .filter = filter};
    for (const Sensor& sensor : vehicle_.sensors) study.channels.push_back({sensor.name, {.channels = {sensor.name}}});
    study.file = folder_.Write("sweep.csv", StationCsv(RecordStation(vehicle_, SensorModel::Filter{4, 30}), vehicle_));
    Diagnostics diagnostics;
    auto histories = LoadHistories({study}, "study.yaml", vehicle_, diagnostics);
    EXPECT_TRUE(histories) << diagnostics.Format();
    return *histories;
  }

  HistoryResiduals Residuals(std::vector<MeasuredHistory> histories, const HistoryResiduals::Options& options = {}) {
    return {std::make_shared<const CondensedVehicle>(vehicle_), std::move(histories), options};
  }

  double WorstNmse(const HistoryResiduals& residuals) {
    double worst = 0;
    for (const HistoryMisfit& misfit :
         HistoryMisfits(residuals.histories(), residuals.Modelled(vehicle_.ParameterValues())))
      worst = std::max(worst, misfit.nmse_percent);
    return worst;
  }

  Vehicle vehicle_ = RubbingStation();
  TemporaryFolder folder_;
};

TEST_F(HistoryResidualsTest, DoNotDependOnSamplesThatWereNotMeasured) {
  for (const HistoryCost cost : {HistoryCost::kWhitened, HistoryCost::kCompromise}) {
    std::vector<MeasuredHistory> histories = Recording();
    for (MeasuredSignal& signal : histories.front().signals) {
      signal.is_unknown.resize(static_cast<std::size_t>(signal.values.size()));
      for (std::size_t k = 1001; k < 1050; ++k) signal.is_unknown[k] = true;
    }
    const HistoryResiduals as_they_were = Residuals(histories, {.cost = cost});
    const double nmse = WorstNmse(as_they_were);
    // As large as the signal: its deviation stays about the same.
    for (MeasuredSignal& signal : histories.front().signals)
      for (Eigen::Index k = 1001; k < 1050; ++k) signal.values[k] = -signal.values[k] + signal.Deviation();
    const HistoryResiduals invented = Residuals(histories, {.cost = cost});
    EXPECT_NEAR(WorstNmse(invented), nmse, 0.01 * nmse);
    EXPECT_NEAR(invented.At(vehicle_.ParameterValues()).norm(), as_they_were.At(vehicle_.ParameterValues()).norm(),
                0.02 * as_they_were.At(vehicle_.ParameterValues()).norm());
    const Eigen::VectorXd residuals = invented.At(vehicle_.ParameterValues());
    for (const ResidualSeries& series : invented.Structure().series) {
      EXPECT_EQ(series.unmeasured, (residuals.segment(series.first, series.count).array() == 0).count());
      EXPECT_GT(series.unmeasured, 0);
    }
  }
}

// A true post and one filter, against heights that the filter took amplitude from and none.
TEST_F(HistoryResidualsTest, VanishForTheVehicleThatWasRecorded) {
  const double filter_taken_back = WorstNmse(Residuals(Recording()));
  const double as_recorded = WorstNmse(Residuals(Recording(std::nullopt)));
  // The square of the integration's error of 1e-3.
  EXPECT_LT(filter_taken_back, 1e-3);
  EXPECT_GT(as_recorded, 0.05);
}

TEST_F(HistoryResidualsTest, AreOverNoiseAndModelError) {
  std::vector<MeasuredHistory> histories = Recording();
  histories[0].signals.resize(1);
  histories[0].signals[0].noise_sd = 0.03 * histories[0].signals[0].Deviation();
  vehicle_.parameters[0].value *= 1.1;
  const HistoryResiduals residuals = Residuals(histories, {.model_error = 0.04});
  const Eigen::VectorXd modelled = residuals.Modelled(vehicle_.ParameterValues())[0].col(0);
  const Eigen::VectorXd given = residuals.At(vehicle_.ParameterValues());
  ASSERT_EQ(given.size(), (modelled.size() + 4) / 5);
  const double sd = 0.05 * histories[0].signals[0].Deviation();
  for (const Eigen::Index k : {0, 1, 100, 555})
    EXPECT_NEAR(given[k], (modelled[5 * k] - histories[0].signals[0].values[5 * k]) / sd, 1e-12);
}

// Against noise of other seeds that is added to the heights. Both are means of squares over sixteen records, each of
// which holds some six independent samples of the body's motion: four standard deviations of the ratio of their roots.
TEST_F(HistoryResidualsTest, ChangeByNoiseOfPostsAsByNoiseInTheirRecord) {
  constexpr double kSd_m = 1e-4;
  constexpr int kRecords = 16;
  constexpr double kMost = 1.4;
  vehicle_ = ShippedVehicle("single_wheel_station");
  MeasuredHistory history = Recording(std::nullopt).front();
  history.post_noise_sd = {kSd_m};
  history.post_noise_is_stated = {1};
  const HistoryResiduals residuals = Residuals(std::vector<MeasuredHistory>(kRecords, history));
  const std::vector<double> values = vehicle_.ParameterValues();
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(std::ssize(history.signals));
  for (const Eigen::VectorXd& sizes : residuals.ByPostNoise(values)) expected += sizes.cwiseAbs2();
  RandomStream random(3, "noise");
  Eigen::VectorXd found = Eigen::VectorXd::Zero(expected.size());
  for (int record = 0; record < kRecords; ++record) {
    std::vector<double> noise(history.heights[0].size());
    for (double& one : noise) one = kSd_m * random.Normal();
    const auto with_noise = [&](double sign) {
      MeasuredHistory noisy = history;
      for (std::size_t k = 0; k < noise.size(); ++k) noisy.heights[0][k] += sign * noise[k];
      noisy.posts = FollowHeights(noisy.heights, noisy.posts.start_s, 1 / noisy.rate_Hz);
      return Residuals({noisy}).At(values);
    };
    const Eigen::VectorXd change = 0.5 * (with_noise(1) - with_noise(-1));
    const Eigen::Index each = change.size() / found.size();
    for (Eigen::Index i = 0; i < found.size(); ++i)
      found[i] += change.segment(i * each, each).squaredNorm() / static_cast<double>(each);
  }
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    ASSERT_GT(found[i], 0);
    const double ratio = std::sqrt(expected[i] / found[i]);
    EXPECT_LT(std::max(ratio, 1 / ratio), kMost) << i << ' ' << ratio;
  }
}

// Each against another way of making the same change: of channels that of the record, of posts that of its heights.
TEST_F(HistoryResidualsTest, ChangeByCalibrationsAsByInstruments) {
  const std::vector<MeasuredHistory> histories = Recording();
  const HistoryResiduals residuals = Residuals(histories);
  const std::vector<double> values = vehicle_.ParameterValues();
  const Eigen::VectorXd here = residuals.At(values);
  std::vector<Calibration> calibrations;
  for (const Sensor& sensor : vehicle_.sensors) calibrations.push_back({.of = sensor.name, .sd = 1e-3});
  calibrations.push_back({.of = Calibration::kPosts, .sd = 1e-3});
  calibrations.push_back({.kind = Calibration::Kind::kDelay, .of = Calibration::kPosts, .sd = 1e-4});
  const Eigen::MatrixXd changes = residuals.ByCalibrations(calibrations, values);

  // Of the vehicle that made the record, a channel that reads less.
  const Eigen::Index sensors = std::ssize(vehicle_.sensors);
  for (Eigen::Index s = 0; s < sensors; ++s) {
    std::vector<MeasuredHistory> less = histories;
    less[0].signals[static_cast<std::size_t>(s)].values *= 1 - 1e-3;
    const Eigen::VectorXd by_record = Residuals(less).At(values) - here;
    // The second order, a thousandth, and a model error that is a share of what is read; of residuals of 1e-3 that is
    // as much again.
    EXPECT_LT((changes.col(s) - by_record).norm(), 0.02 * by_record.norm())
        << histories[0].signals[static_cast<std::size_t>(s)].name;
  }
  MeasuredHistory larger = histories[0];
  larger.posts.motion = [motion = larger.posts.motion](double t, std::span<PostState> posts) {
    motion(t, posts);
    for (PostState& post : posts) post = {1.001 * post.height, 1.001 * post.velocity, 1.001 * post.acceleration};
  };
  const Eigen::VectorXd by_gain = Residuals({larger}).At(values) - here;
  EXPECT_LT((changes.col(sensors) - by_gain).norm(), 1e-6 * by_gain.norm());
  MeasuredHistory earlier = histories[0];
  earlier.posts.motion = [motion = earlier.posts.motion](double t, std::span<PostState> posts) {
    motion(t + 1e-4, posts);
  };
  const Eigen::VectorXd by_delay = Residuals({earlier}).At(values) - here;
  EXPECT_LT((changes.col(sensors + 1) - by_delay).norm(), 1e-6 * by_delay.norm());
}

// Of the model goes what a high-pass takes from the record, so that nothing is left in the middle of the window.
TEST_F(HistoryResidualsTest, TakeFromTheModelWhatIsTakenFromTheRecord) {
  std::vector<MeasuredHistory> histories = Recording();
  MeasuredHistory& history = histories[0];
  history.signals.resize(1);
  const Eigen::VectorXd before = history.signals[0].values;
  ASSERT_EQ(history.signals[0].source.channels.size(), 1u);
  history.signals[0].source.channels[0].high_pass_Hz = 2;
  RemoveSlow({history.signals[0].values.data(), static_cast<std::size_t>(history.count)}, history.rate_Hz, 2);
  const Eigen::VectorXd measured = history.signals[0].values;
  ASSERT_GT((before - measured).norm(), 0.1 * before.norm());
  const Eigen::VectorXd modelled = Residuals(histories).Modelled(vehicle_.ParameterValues())[0].col(0);
  const Eigen::Index ends = std::lround(2 * history.rate_Hz);
  const Eigen::Index count = history.count - 2 * ends;
  const Eigen::VectorXd error = (modelled - measured).segment(ends, count);
  // Of the filter's memory a ten-thousandth is left after two seconds; of the integration's error 3e-3.
  EXPECT_LT(error.norm(), 5e-3 * measured.segment(ends, count).norm());
}

// Central differences whose steps are a ten-thousandth leave some 1e-4 where friction turns about.
TEST_F(HistoryResidualsTest, HaveTheDerivativesOfDifferences) {
  const std::vector<double> values = vehicle_.ParameterValues();
  std::vector<std::size_t> all(values.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const HistoryCost cost : {HistoryCost::kWhitened, HistoryCost::kCompromise}) {
    const HistoryResiduals residuals = Residuals(Recording(), {.cost = cost});
    ASSERT_TRUE(residuals.HasDerivatives());
    // Away from the truth, where the compromise has no slope.
    std::vector<double> here = values;
    here[0] *= 1.1;
    const Eigen::MatrixXd derivatives = residuals.Derivatives(here, all);
    for (std::size_t p = 0; p < here.size(); ++p) {
      const auto at = [&](double share) {
        std::vector<double> other = here;
        other[p] *= 1 + share;
        return residuals.At(other);
      };
      const Eigen::VectorXd expected = (at(1e-4) - at(-1e-4)) / (2e-4 * here[p]);
      EXPECT_LT((derivatives.col(static_cast<Eigen::Index>(p)) - expected).norm(), 5e-3 * expected.norm())
          << vehicle_.parameters[p].name;
    }
  }
}

TEST_F(HistoryResidualsTest, OfTheCompromiseAddUpToItsCost) {
  vehicle_.parameters[0].value *= 1.1;
  const HistoryResiduals residuals = Residuals(Recording(), {.cost = HistoryCost::kCompromise});
  double cost = 0;
  for (const HistoryMisfit& misfit :
       HistoryMisfits(residuals.histories(), residuals.Modelled(vehicle_.ParameterValues())))
    cost += misfit.nmse_percent * misfit.nmse_percent;
  EXPECT_NEAR(residuals.At(vehicle_.ParameterValues()).squaredNorm(), cost, 1e-12 * cost);
}

TEST_F(HistoryResidualsTest, AskTheirDeadline) {
  const HistoryResiduals residuals = Residuals(Recording());
  EXPECT_THROW(residuals.At(vehicle_.ParameterValues(), Deadline::In(1e-9)), TimedOut);
}

TEST_F(HistoryResidualsTest, TellOfADelayAndOfAWrongSign) {
  std::vector<MeasuredHistory> histories = Recording();
  MeasuredSignal& delayed = histories[0].signals[0];
  delayed.values.tail(delayed.values.size() - 10) = delayed.values.head(delayed.values.size() - 10).eval();
  histories[0].signals[4].values *= -1;
  const HistoryResiduals residuals = Residuals(histories);
  const std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, residuals.Modelled(vehicle_.ParameterValues()));
  EXPECT_NEAR(*misfits[0].delay_s, 0.02, 1e-4);
  EXPECT_GT(misfits[0].nmse_percent, 100 * *misfits[0].timed_nmse_percent);
  EXPECT_NEAR(*misfits[4].gain, -1, 1e-3);
  EXPECT_NEAR(*misfits[1].delay_s, 0, 1e-5);
}

TEST_F(HistoryResidualsTest, TellOfSwappedChannels) {
  std::vector<MeasuredHistory> histories = Recording();
  std::swap(histories[0].signals[0].values, histories[0].signals[1].values);
  const HistoryResiduals residuals = Residuals(histories);
  const std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, residuals.Modelled(vehicle_.ParameterValues()));
  EXPECT_EQ(misfits[0].swapped_with, "z_unsprung");
  EXPECT_EQ(misfits[1].swapped_with, "z_sprung");
  for (const std::size_t i : {2u, 3u, 4u}) EXPECT_FALSE(misfits[i].swapped_with) << i;
}

// Stiff friction in a vehicle whose file has none: the file's steps are too long for it.
TEST_F(HistoryResidualsTest, TellWhereHalfTheStepChangesThem) {
  const std::vector<MeasuredHistory> histories = Recording();
  const HistoryResiduals residuals = Residuals(histories);
  const std::vector<double> same = residuals.ChangesByHalfStep(vehicle_.ParameterValues());
  ASSERT_EQ(same.size(), 1u);
  // A halving changed less than the error asked for; the next changes less still.
  EXPECT_LT(same[0], residuals.options().error);
  vehicle_.dampers[0].law.friction = DashpotDescription::Friction{.force = {400}, .speed = {1e-4}};
  std::vector<MeasuredHistory> again = histories;
  const HistoryResiduals rough(std::make_shared<const CondensedVehicle>(vehicle_), again, {.error = 0.5});
  EXPECT_GT(rough.ChangesByHalfStep(vehicle_.ParameterValues())[0], residuals.options().error);
}

TEST_F(HistoryResidualsTest, AgreeWithTheMultibodySystem) {
  const std::vector<MeasuredHistory> histories = Recording();
  const Eigen::MatrixXd condensed = Residuals(histories).Modelled(vehicle_.ParameterValues())[0];
  const std::vector<double> values = vehicle_.ParameterValues();
  const std::optional<EngineHistory> answer = SimulateBy({.engine = Engine::kFull}, histories[0], vehicle_, values);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->by.engine, Engine::kFull);
  const Eigen::MatrixXd& full = answer->modelled;
  for (Eigen::Index i = 0; i < condensed.cols(); ++i)
    // The condensed steps' error; the wheel moves straight, so that linear kinematics leave nothing out.
    EXPECT_LT((condensed.col(i) - full.col(i)).norm(), 3e-3 * full.col(i).norm()) << i;
  EXPECT_FALSE(SimulateBy({}, histories[0], vehicle_, values, [](const char*, double) { return false; }));
}

TEST_F(HistoryResidualsTest, AsABlockTurnFaultsOfTheMotionIntoFailures) {
  // Off the ground no tyre pushes any more.
  for (Tyre& tyre : vehicle_.tyres) tyre.lifts_off = false;
  const ResidualBlock block =
      HistoryBlock(std::make_shared<const CondensedVehicle>(vehicle_), Recording(), HistoryResiduals::Options{});
  EXPECT_EQ(block.evaluate(vehicle_.ParameterValues(), {}).residuals.size(), block.count);
  // A tyre that pushes the wheel away.
  Set(vehicle_, "kt", -ValueOf(vehicle_, "kt"));
  const Evaluation failed = block.evaluate(vehicle_.ParameterValues(), {});
  EXPECT_EQ(failed.failure, Failure::kNotConverged);
  EXPECT_THAT(failed.detail, testing::HasSubstr("[motion-unbounded]"));
}

}  // namespace
}  // namespace fourpost::history_residuals_test
