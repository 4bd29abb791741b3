#include "identify/experiments/time_history/history_data.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include <gmock/gmock.h>

#include "analysis/files/findings.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/identify/recorded_station.h"
#include "tests/temporary_folder.h"
#include "vehicles/condensed/mode_times.h"

namespace fourpost::history_data_test {
namespace {

class HistoryDataTest : public testing::Test {
 protected:
  HistoryDataTest() {
    history_.name = "sweep";
    history_.posts = {{"ground", {.channels = {"z_ground"}, .line = 4}}};
    for (const Sensor& sensor : vehicle_.sensors)
      history_.channels.push_back({sensor.name, {.channels = {sensor.name}, .line = 5}});
    history_.line = 3;
  }

  std::optional<std::vector<MeasuredHistory>> Load(const std::string& text) {
    history_.file = folder_.Write("sweep.csv", text);
    return LoadHistories({history_}, "study.yaml", vehicle_, diagnostics_);
  }
  std::optional<std::vector<MeasuredHistory>> Load() { return Load(StationCsv(recorded_, vehicle_)); }

  /// The one fault.
  Diagnostics Fault(const std::string& text) {
    EXPECT_FALSE(Load(text));
    EXPECT_EQ(diagnostics_.items().size(), 1u) << diagnostics_.Format();
    return diagnostics_;
  }
  Diagnostics Fault() { return Fault(StationCsv(recorded_, vehicle_)); }

  Vehicle vehicle_ = ShippedVehicle("single_wheel_station");
  TimeHistory recorded_ = RecordStation(vehicle_, std::nullopt);
  TemporaryFolder folder_;
  StudyHistory history_;
  Diagnostics diagnostics_;
};

TEST_F(HistoryDataTest, TakesOffsetsAway) {
  const auto histories = Load();
  ASSERT_TRUE(histories) << diagnostics_.Format();
  const MeasuredHistory& history = histories->front();
  EXPECT_NEAR(history.rate_Hz, 500, 1e-9);
  EXPECT_EQ(history.count, recorded_.size());
  ASSERT_EQ(history.signals.size(), 5u);
  EXPECT_EQ(history.signals[4].unit, "N");
  for (const MeasuredSignal& signal : history.signals) EXPECT_NEAR(signal.values.mean(), 0, 1e-9 * signal.Deviation());
  std::vector<PostState> post(1);
  const double mean = recorded_.posts.mean();
  for (const Eigen::Index k : {500, 1234, 2000}) {
    history.posts.motion(history.TimeAt(k), post);
    // Digits of the file.
    EXPECT_NEAR(post[0].height, recorded_.posts(k, 0) - mean, 1e-9);
  }
}

TEST_F(HistoryDataTest, LeavesOutWhatTheFilterKeepsBack) {
  history_.filter = LowPassDesign{.order = 4, .cutoff_Hz = 30};
  const auto histories = Load();
  ASSERT_TRUE(histories);
  EXPECT_NEAR(histories->front().TimeAt(histories->front().count - 1), 6.5 - 4 / 30.0, 2e-3);
  EXPECT_EQ(histories->front().Stride(), 5);
}

TEST_F(HistoryDataTest, HasTheWindowAskedFor) {
  history_.start_s = 1;
  history_.end_s = 3;
  const auto histories = Load();
  ASSERT_TRUE(histories);
  EXPECT_DOUBLE_EQ(histories->front().TimeAt(0), 1);
  EXPECT_EQ(histories->front().count, 1001);
  history_.start_s = 7;
  history_.end_s.reset();
  EXPECT_THAT(Fault(), Reports(kHistoryWindowOutside, 3, {"'sweep'", "0 s", "6.5 s"}));
  EXPECT_EQ(diagnostics_.items().at(0).place.file, "study.yaml");
}

TEST_F(HistoryDataTest, AddsChannelsUp) {
  history_.channels = {{"F_tyre", {.combine = ChannelSource::Combine::kSum, .channels = {"F_tyre", "F_tyre"}}}};
  const auto sum = Load();
  history_.channels = {{"F_tyre", {.channels = {"F_tyre", "F_tyre"}}}};
  const auto mean = Load();
  ASSERT_TRUE(sum && mean);
  EXPECT_TRUE(sum->front().signals[0].values.isApprox(2 * mean->front().signals[0].values));
}

TEST_F(HistoryDataTest, RefusesNamesThatAreNotThere) {
  history_.channels[0].first = "z_sprang";
  EXPECT_THAT(Fault(), Reports(kHistorySensorUnknown, 5, {"'z_sprang'", "'z_sprung'"}));
  diagnostics_ = {};
  history_.channels[0].first = "z_sprung";
  history_.channels[1].second.channels = {"z_unspring"};
  EXPECT_THAT(Fault(), Reports(kChannelColumnMissing, 1, {"'z_unspring'"}));
  diagnostics_ = {};
  history_.channels.pop_back();
  history_.channels[1].second.channels = {"z_unsprung"};
  history_.posts.clear();
  EXPECT_THAT(Fault(), Reports(kHistoryPostMissing, 3, {"'sweep'", "'ground'"}));
}

TEST_F(HistoryDataTest, RefusesAnotherUnit) {
  history_.channels[0].second.channels = {"F_tyre"};
  history_.channels.resize(1);
  EXPECT_THAT(Fault(), Reports(kUnitOfOtherDimension, 2, {"'F_tyre'", "'z_sprung'"}));
}

TEST_F(HistoryDataTest, ReadsNoise) {
  history_.noise = {{"F_tyre", "0.02 kN", 6}};
  const auto histories = Load();
  ASSERT_TRUE(histories);
  EXPECT_DOUBLE_EQ(histories->front().signals[4].noise_sd, 20);
  history_.noise = {{"F_tyre", "20 mm", 6}};
  EXPECT_THAT(Fault(), Reports(kNoiseUnreadable, 6, {"'F_tyre'", "N", "'20 mm'"}));
}

TEST_F(HistoryDataTest, RefusesSamplesTooFarApartForTheBand) {
  history_.filter = LowPassDesign{.order = 4, .cutoff_Hz = 150};
  EXPECT_THAT(Fault(), Reports(kSampledTooSlowly, 3, {"sweep.csv", "500 Hz", "150 Hz", "600 Hz"}));
}

TEST_F(HistoryDataTest, WarnsOfPostsSampledTooSlowly) {
  EXPECT_TRUE(Load());
  EXPECT_EQ(diagnostics_.Format(), "");
  // Of 20 Hz and 500 Hz every eighth sample is left.
  TimeHistory slow = recorded_;
  slow.rate_Hz /= 8;
  const Eigen::Index kept = recorded_.size() / 8;
  slow.posts = recorded_.posts(Eigen::seqN(0, kept, 8), Eigen::all);
  slow.readings = recorded_.readings(Eigen::seqN(0, kept, 8), Eigen::all);
  EXPECT_TRUE(Load(StationCsv(slow, vehicle_)));
  EXPECT_THAT(diagnostics_, Reports(kPostSampledTooSlowly, 3, {"'ground'", "62.5 Hz", "6 samples"}));
}

TEST_F(HistoryDataTest, TakesNoiseOfAPostForNoMotion) {
  TimeHistory noisy = recorded_;
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 0.1e-3);
  for (double& height : noisy.posts.reshaped()) height += noise(random);
  EXPECT_TRUE(Load(StationCsv(noisy, vehicle_)));
  EXPECT_THAT(diagnostics_.Format(), testing::Not(testing::HasSubstr("post-sampled-too-slowly")));
}

TEST_F(HistoryDataTest, NamesNoChannelOfAnotherQuantityForOneThatIsMissing) {
  std::string text = StationCsv(recorded_, vehicle_);
  text.replace(text.find("z_sprung"), 8, "z_body__");
  // Nearest by its letters is a_sprung, an acceleration.
  EXPECT_THAT(Fault(text), Reports(kChannelColumnMissing, 1, {"'z_sprung'"}));
  EXPECT_THAT(diagnostics_, testing::Not(Reports(kChannelColumnMissing, 1, {"a_sprung"})));
}

TEST_F(HistoryDataTest, RefusesADeadChannel) {
  recorded_.readings.col(2).setConstant(0.3);
  EXPECT_FALSE(Load());
  EXPECT_THAT(diagnostics_, Reports(kChannelDead, 5, {"'a_sprung'"}));
}

// As the roll rate of a symmetric vehicle in heave: its weight would be that of rounding.
TEST_F(HistoryDataTest, LeavesOutAChannelThatDoesNotMove) {
  recorded_.readings.col(2) *= 2e-4 * recorded_.readings.col(3).norm() / recorded_.readings.col(2).norm();
  auto histories = Load();
  ASSERT_TRUE(histories) << diagnostics_.Format();
  EXPECT_EQ(histories->front().signals.size(), 5u) << "quiet, but beyond a step of its recorder";
  recorded_.readings.col(2) *= 1e-2;
  histories = Load();
  ASSERT_TRUE(histories) << diagnostics_.Format();
  EXPECT_EQ(histories->front().signals.size(), 4u);
  EXPECT_THAT(diagnostics_, Reports(kChannelMotionless, 5, {"'a_sprung' does not move in 'sweep'"}));
}

TEST_F(HistoryDataTest, LeavesOutADeadChannelThatIsNotConstant) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> noise(0, 0.4);
  for (double& value : recorded_.readings.col(2)) value = 0.01 * std::round(noise(engine));
  const auto histories = Load();
  ASSERT_TRUE(histories) << diagnostics_.Format();
  EXPECT_EQ(histories->front().signals.size(), 4u);
  EXPECT_THAT(diagnostics_, Reports(kChannelOnlyNoise, 5, {"channel 'a_sprung' of 'sweep' is dead"}));
}

/// Without some of the lines.
std::string WithGap(const std::string& text, std::size_t first, std::size_t count) {
  std::istringstream lines(text);
  std::string kept;
  std::string line;
  for (std::size_t i = 0; std::getline(lines, line); ++i)
    if (i < first || i >= first + count) kept += line + '\n';
  return kept;
}

TEST_F(HistoryDataTest, KnowsWhichSamplesBridgeAGap) {
  history_.preparation.bridge_s = 0.05;
  // Below names and units.
  const auto histories = Load(WithGap(StationCsv(recorded_, vehicle_), 2 + 1000, 3));
  ASSERT_TRUE(histories) << diagnostics_.Format();
  const MeasuredHistory& history = histories->front();
  EXPECT_EQ(history.count, recorded_.size());
  for (const MeasuredSignal& signal : history.signals)
    for (Eigen::Index k = 0; k < history.count; ++k)
      ASSERT_EQ(!signal.is_unknown.empty() && signal.is_unknown[static_cast<std::size_t>(k)], k >= 1000 && k < 1003)
          << k;
  EXPECT_EQ(history.LongestMeasured().first, 1003);
  EXPECT_EQ(history.LongestMeasured().count, recorded_.size() - 1003);
}

// At 12 Hz a post goes through a period in 80 ms.
TEST_F(HistoryDataTest, TakesTheWeightFromMotionThatFollowsAnUnknownInput) {
  history_.preparation.bridge_s = 0.2;
  const auto histories = Load(WithGap(StationCsv(recorded_, vehicle_), 2 + 1000, 80));
  ASSERT_TRUE(histories) << diagnostics_.Format();
  const MeasuredHistory& history = histories->front();
  const std::vector<char>& is_unknown = history.signals.front().is_unknown;
  EXPECT_FALSE(is_unknown[999]);
  EXPECT_TRUE(is_unknown[1000]);
  double settled_s = 0;
  for (const Mode& mode : ModesOf(CondensedVehicle(vehicle_).At(vehicle_.ParameterValues())))
    settled_s = std::max(settled_s, SettlingTime_s(mode));
  const auto end = static_cast<std::size_t>(1080 + 500 * settled_s);
  EXPECT_TRUE(is_unknown[end - 1]);
  EXPECT_FALSE(is_unknown[end + 1]);
  EXPECT_THAT(diagnostics_, Reports(kInputUnknown, 3, {"'ground' in 'sweep'", "from 1.998 s to 2.16 s"}));
}

TEST_F(HistoryDataTest, RefusesARecordingWithoutAnyMotionThatIsKnown) {
  history_.preparation.bridge_s = 6;
  EXPECT_THAT(Fault(WithGap(StationCsv(recorded_, vehicle_), 2 + 5, 2900)), Reports(kInputNeverKnown, 3, {"'ground'"}));
}

TEST_F(HistoryDataTest, TakesTheWeightFromWhatALoggerHeld) {
  for (Eigen::Index k = 1000; k < 1020; ++k) {
    recorded_.readings.row(k) = recorded_.readings.row(999);
    recorded_.posts.row(k) = recorded_.posts.row(999);
  }
  const auto histories = Load();
  ASSERT_TRUE(histories) << diagnostics_.Format();
  const MeasuredHistory& history = histories->front();
  const std::vector<char>& is_unknown = history.signals[2].is_unknown;
  ASSERT_FALSE(is_unknown.empty());
  EXPECT_FALSE(is_unknown[999]);
  EXPECT_EQ(std::count(is_unknown.begin() + 1000, is_unknown.begin() + 1020, 1), 20);
  EXPECT_THAT(diagnostics_, Reports(kChannelHeld, 1003, {"'z_ground'", "from 1.998 s to 2.04 s", "20 samples"}));
}

TEST_F(HistoryDataTest, NamesSamplesThatStandOut) {
  // As of an impact that one sample sees.
  recorded_.readings(2345, 4) += 2.5 * recorded_.readings.col(4).maxCoeff();
  ASSERT_TRUE(Load()) << diagnostics_.Format();
  EXPECT_THAT(diagnostics_, testing::Not(Reports(kChannelSpiked)));
  recorded_.readings(1234, 4) = 32767;
  ASSERT_TRUE(Load()) << diagnostics_.Format();
  EXPECT_THAT(diagnostics_, Reports(kChannelSpiked, 5, {"'F_tyre'", "1 sample", "2.468 s"}));
}

// Rows are missing where the station moves fast, and the times go on as if they were not.
TEST_F(HistoryDataTest, KnowsTimesThatWereClosedUp) {
  TimeHistory shorter = recorded_;
  constexpr Eigen::Index kLost = 40;
  const Eigen::Index left = recorded_.size() - kLost;
  const auto close = [&](const Eigen::MatrixXd& all) {
    Eigen::MatrixXd kept(left, all.cols());
    kept << all.topRows(800), all.bottomRows(left - 800);
    return kept;
  };
  shorter.posts = close(recorded_.posts);
  shorter.readings = close(recorded_.readings);
  const auto histories = Load(StationCsv(shorter, vehicle_));
  ASSERT_TRUE(histories) << diagnostics_.Format();
  EXPECT_THAT(diagnostics_, Reports(kTimesClosedUp, 3, {"1.598 s"}));
  ASSERT_FALSE(histories->front().signals[0].is_unknown.empty());
  EXPECT_TRUE(histories->front().signals[0].is_unknown[810]);
  EXPECT_FALSE(histories->front().signals[0].is_unknown[790]);
}

// As of a step that a rig was asked for.
TEST_F(HistoryDataTest, TakesAStepOfAPostForNoClosedTimes) {
  recorded_ =
      SimulateCondensed(CondensedVehicle(vehicle_).At(vehicle_.ParameterValues()), RigViewOf(vehicle_),
                        FollowPattern(SmoothStep{.height_m = 0.02, .rise_s = 0.002, .start_s = 1}.Signal(), {1}),
                        {.start_s = 0, .end_s = 4, .rate_Hz = 500}, {.error = 1e-2})
          .history;
  Load();
  EXPECT_THAT(diagnostics_, testing::Not(Reports(kTimesClosedUp)));
}

TEST_F(HistoryDataTest, ReadsNoiseInUnitsOfRecordings) {
  history_.noise = {{vehicle_.sensors[3].name, "0.02 g", 7}};
  const auto histories = Load();
  ASSERT_TRUE(histories) << diagnostics_.Format();
  EXPECT_DOUBLE_EQ(histories->front().signals[3].noise_sd, 0.02 * 9.80665);
}

TEST_F(HistoryDataTest, WarnsOfASaturatedSensor) {
  ASSERT_TRUE(Load());
  EXPECT_EQ(diagnostics_.Format(), "");
  const double limit = 0.5 * recorded_.readings.col(4).maxCoeff();
  recorded_.readings.col(4) = recorded_.readings.col(4).cwiseMin(limit);
  const auto histories = Load();
  ASSERT_TRUE(histories);
  const std::vector<char>& is_unknown = histories->front().signals[4].is_unknown;
  EXPECT_EQ(std::count(is_unknown.begin(), is_unknown.end(), 1), (recorded_.readings.col(4).array() == limit).count());
  EXPECT_THAT(diagnostics_, Reports(kSamplesSaturated, 5, {"'F_tyre' is clipped"}));
}

// A post may be commanded to stand, but with noise of its transducer no sample repeats.
TEST_F(HistoryDataTest, WarnsOfAClippedPost) {
  auto post = recorded_.posts.col(0);
  const Eigen::VectorXd moved = post;
  for (Eigen::Index k = 0; k < post.size(); ++k)
    post[k] = std::clamp(0.0001 * static_cast<double>(std::abs(k % 800 - 400) - 200), -0.01, 0.01);
  ASSERT_TRUE(Load());
  EXPECT_THAT(diagnostics_.Format(), testing::Not(testing::HasSubstr("post-saturated")));
  std::mt19937_64 engine(1);
  std::normal_distribution<double> noise(0, 1e-5);
  const double limit = 0.7 * moved.maxCoeff();
  for (Eigen::Index k = 0; k < post.size(); ++k) post[k] = std::min(limit, moved[k] + noise(engine));
  ASSERT_TRUE(Load());
  EXPECT_THAT(diagnostics_, Reports(kPostSaturated, 3, {"'ground'", "is clipped"}));
}

// Noise that came in behind the sensor; what is told to be done helps.
TEST_F(HistoryDataTest, WarnsOfASaturatedSensorUnderNoise) {
  auto force = recorded_.readings.col(4);
  const double limit = 0.7 * force.maxCoeff();
  Eigen::Index first = 0;
  while (force[first] < limit) ++first;
  const auto clipped = force.cwiseMin(limit).eval();
  std::mt19937_64 engine(1);
  std::normal_distribution<double> noise(0, 1e-3 * limit);
  for (Eigen::Index k = 0; k < force.size(); ++k) force[k] += noise(engine);
  ASSERT_TRUE(Load());
  EXPECT_EQ(diagnostics_.Format(), "");
  for (Eigen::Index k = 0; k < force.size(); ++k) force[k] = clipped[k] + noise(engine);
  ASSERT_TRUE(Load());
  EXPECT_THAT(diagnostics_, Reports(kChannelSaturated, 5, {"'F_tyre' looks clipped"}));
  diagnostics_ = {};
  history_.end_s = recorded_.TimeAt(first - 1);
  ASSERT_TRUE(Load());
  EXPECT_EQ(diagnostics_.Format(), "");
}

TEST_F(HistoryDataTest, AFaultyValidationRecordingIsLeftOut) {
  history_.file = folder_.Write("sweep.csv", "time,z_ground\ns,m\n0,0\n");
  StudyHistory missing = history_;
  missing.name = "missing";
  missing.file = folder_.path() / "swoop.csv";
  std::vector<LeftOutRecording> left_out;
  EXPECT_TRUE(LoadValidation({history_, missing}, "study.yaml", vehicle_, diagnostics_, left_out).empty());
  EXPECT_FALSE(diagnostics_.HasErrors());
  ASSERT_EQ(left_out.size(), 2u);
  EXPECT_EQ(left_out[0].name, "sweep");
  EXPECT_THAT(diagnostics_, Reports(kValidationLeftOut, 1, {"'sweep'"}));
  EXPECT_THAT(diagnostics_, Reports(kChannelColumnMissing, 1));
  EXPECT_THAT(diagnostics_, Reports(kValidationLeftOut, 3, {"'missing'"}));
  EXPECT_THAT(diagnostics_, Reports(kFileNotThere, 3, {"swoop.csv"}));
  EXPECT_THAT(left_out[1].reason, testing::HasSubstr("swoop.csv"));
}

TEST_F(HistoryDataTest, ASteppedSineIsToldWhereItBelongs) {
  EXPECT_THAT(Fault("frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n1,0.01,a_body,1,0\n"),
              Reports(kSteppedSineAsHistory, 1));
}

}  // namespace
}  // namespace fourpost::history_data_test
