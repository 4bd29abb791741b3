#include "identify/experiments/time_history/motion_file.h"

#include <cmath>

#include <gmock/gmock.h>

#include "identify/experiments/time_history/findings.h"
#include "tests/findings.h"
#include "tests/identify/recorded_station.h"
#include "tests/temporary_folder.h"

namespace fourpost::motion_file_test {
namespace {

using Eigen::Index;

MeasuredHistory StationSweep(const Vehicle& vehicle, const TemporaryFolder& folder) {
  StudyHistory study{.name = "sweep", .posts = {{"ground", {.channels = {"z_ground"}}}}};
  study.channels.push_back({"z_sprung", {.channels = {"z_sprung"}}});
  study.file = folder.Write("sweep.csv", StationCsv(RecordStation(vehicle, std::nullopt), vehicle));
  Diagnostics diagnostics;
  const auto histories = LoadHistories({study}, "study.yaml", vehicle, diagnostics);
  EXPECT_TRUE(histories) << diagnostics.Format();
  return histories->front();
}

TEST(HistoryMotion, IsWhatTheSensorsRead) {
  const Vehicle vehicle = ShippedVehicle("single_wheel_station");
  const TemporaryFolder folder;
  const MeasuredHistory history = StationSweep(vehicle, folder);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const HistorySimulation simulation(history, 1e-3);
  const HistoryMotion motion = simulation.Motion(model, 1);
  ASSERT_EQ(motion.coordinates.rows(), history.count);
  ASSERT_EQ(motion.coordinates.cols(), model.mass.rows());
  const Eigen::MatrixXd modelled = simulation.Run(model);
  Eigen::VectorXd read =
      motion.coordinates * model.on_position.row(static_cast<Index>(history.signals[0].sensor)).transpose();
  read.array() -= read.mean();
  // Rounding.
  EXPECT_LT((read - modelled.col(0)).norm(), 1e-12 * modelled.col(0).norm());
  // The posts, and every eighth of all that.
  std::vector<PostState> posts(1);
  const HistoryMotion thinned = simulation.Motion(model, 8);
  EXPECT_EQ(thinned.rate_Hz, history.rate_Hz / 8);
  ASSERT_EQ(thinned.posts.rows(), (history.count - 1) / 8 + 1);
  for (const Index k : {Index{0}, Index{100}, thinned.posts.rows() - 1}) {
    history.posts.motion(history.TimeAt(8 * k), posts);
    EXPECT_NEAR(thinned.posts(k, 0), posts[0].height, 1e-12);
    EXPECT_EQ(thinned.coordinates.row(k), motion.coordinates.row(8 * k));
  }
  EXPECT_THROW(simulation.Motion(model, 0), std::invalid_argument);
}

TEST(FrameStride, KeepsSixtyFramesAndABoundedPage) {
  MeasuredHistory history{.rate_Hz = 500, .count = 30000};
  EXPECT_EQ(FrameStride(history, 6), 9);
  history.rate_Hz = 60;
  history.count = 600;
  EXPECT_EQ(FrameStride(history, 6), 1);
  // 60000 numbers of 100 columns.
  history.count = 6000;
  EXPECT_EQ(FrameStride(history, 100), 10);
}

class MotionFileTest : public testing::Test {
 protected:
  std::vector<RecordedHistory> Histories() const {
    Eigen::MatrixXd posts(3, 1);
    posts << 0.01, -0.0123456, 0;
    Eigen::MatrixXd coordinates(3, 2);
    coordinates << 0.1, 1e-9, 0.2, -0.3, 0, 4;
    return {{"sweep, \"fast\"", {2, 50, posts, coordinates}}, {"other", {0, 25, -posts, -coordinates}}};
  }

  auto Reading(const std::string& text) const {
    return [this, text] { ReadMotionCsv(text, "motion.csv", vehicle_); };
  }

  Vehicle vehicle_ = ShippedVehicle("quarter_car");
};

TEST_F(MotionFileTest, ReadsBackWhatItWrites) {
  const std::vector<RecordedHistory> written = Histories();
  const std::vector<RecordedHistory> read = ReadMotionCsv(MotionCsv(vehicle_, written), "motion.csv", vehicle_);
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t h = 0; h < 2; ++h) {
    EXPECT_EQ(read[h].name, written[h].name);
    EXPECT_EQ(read[h].motion.start_s, written[h].motion.start_s);
    EXPECT_NEAR(read[h].motion.rate_Hz, written[h].motion.rate_Hz, 1e-9);
    // Seven decimals.
    EXPECT_LE((read[h].motion.posts - written[h].motion.posts).cwiseAbs().maxCoeff(), 0.51e-7);
    EXPECT_LE((read[h].motion.coordinates - written[h].motion.coordinates).cwiseAbs().maxCoeff(), 0.51e-7);
  }
}

TEST_F(MotionFileTest, SaysWhatIsWrong) {
  const std::string text = MotionCsv(vehicle_, Histories());
  EXPECT_THAT(Reading("recording,time_s,coordinate_1\nsweep,0,0\n"), Refuses(kMotionColumns, 1));
  EXPECT_THAT(Reading("recording\nsweep\n"), Refuses(kMotionColumns, 1));
  std::string gap = text;
  gap.replace(gap.find("2.02,"), 5, "2.03,");
  EXPECT_THAT(Reading(gap), Refuses(kMotionUneven, 2, {"sweep, \"fast\""}));
  std::string word = text;
  word.replace(word.find("2.02,"), 5, "soon,");
  EXPECT_THAT(Reading(word), Refuses(kMotionUneven, 2, {"sweep, \"fast\""}));
}

}  // namespace
}  // namespace fourpost::motion_file_test
