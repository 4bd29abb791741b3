#include "identify/experiments/time_history/start_state.h"

#include <memory>
#include <string>

#include <gmock/gmock.h>

#include "identify/experiments/time_history/history_misfits.h"
#include "identify/experiments/time_history/history_residuals.h"
#include "tests/identify/recorded_station.h"
#include "tests/temporary_folder.h"

namespace fourpost::start_state_test {
namespace {

/// Names, units, and all but the first samples.
std::string Without(int samples, const std::string& csv) {
  std::size_t head = csv.find('\n', csv.find('\n') + 1) + 1;
  std::size_t rest = head;
  for (int k = 0; k < samples; ++k) rest = csv.find('\n', rest) + 1;
  return csv.substr(0, head) + csv.substr(rest);
}

// A recording that begins while everything moves: the state there is nowhere in it.
TEST(StartState, OfARecordingThatBeginsInMotionIsFound) {
  const Vehicle vehicle = ShippedVehicle("single_wheel_station");
  TemporaryFolder folder;
  StudyHistory study{.name = "sweep", .posts = {{"ground", {.channels = {"z_ground"}}}}};
  for (const Sensor& sensor : vehicle.sensors) study.channels.push_back({sensor.name, {.channels = {sensor.name}}});
  study.file = folder.Write("sweep.csv", Without(1150, StationCsv(RecordStation(vehicle, std::nullopt), vehicle)));
  Diagnostics diagnostics;
  const auto histories = LoadHistories({study}, "study.yaml", vehicle, diagnostics);
  ASSERT_TRUE(histories) << diagnostics.Format();
  const auto condensed = std::make_shared<const CondensedVehicle>(vehicle);
  const auto worst = [&](HistoryCost cost) {
    const HistoryResiduals residuals(condensed, *histories, {.cost = cost});
    double percent = 0;
    for (const HistoryMisfit& misfit : HistoryMisfits(*histories, residuals.Modelled(vehicle.ParameterValues())))
      percent = std::max(percent, misfit.nmse_percent);
    return percent;
  };
  // Found for whitened residuals only. Its dashpot is linear, the station's is not: hence not zero.
  EXPECT_LT(worst(HistoryCost::kWhitened), 0.1 * worst(HistoryCost::kCompromise));
  // Marched from that state it is, whatever the damper: what is left is the integration's error of 1e-3, squared.
  const HistoryResiduals residuals(condensed, *histories, {});
  const std::vector<double> values = vehicle.ParameterValues();
  const auto answer = SimulateBy({.engine = Engine::kReduced}, histories->front(), vehicle, values);
  ASSERT_TRUE(answer);
  for (const HistoryMisfit& misfit : HistoryMisfits(*histories, {residuals.WithStart(0, values, answer->modelled)}))
    EXPECT_LT(misfit.nmse_percent, 1e-3) << misfit.name;
}

/// A minute at 200 Hz, filtered, whose window begins after 1 s.
MeasuredHistory LongHistory(const Vehicle& vehicle, Eigen::Index first) {
  MeasuredHistory history{
      .name = "long", .rate_Hz = 200, .filter = LowPassDesign{.order = 4, .cutoff_Hz = 10}, .first = first};
  history.count = 12000 - first;
  for (std::size_t i = 0; i < vehicle.sensors.size(); ++i) history.signals.push_back({.sensor = i});
  return history;
}

// Signals have no mean, and what is cut off is no more than rounding.
TEST(StartState, OfALongRecordingIsFollowedUntilNothingIsLeft) {
  const Vehicle vehicle = ShippedVehicle("single_wheel_station");
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const MeasuredHistory history = LongHistory(vehicle, 200);
  const FreeMotion motion = FreeMotionOf(history, model);
  ASSERT_GT(motion.later.cols(), 2);
  for (Eigen::Index s = 0; s < motion.later.rows(); ++s) {
    const Eigen::MatrixXd& first = motion.first[static_cast<std::size_t>(s)];
    const Eigen::MatrixXd all = motion.Rows(s, history.count, 1);
    EXPECT_LT(first.rows(), history.count / 4);
    for (Eigen::Index c = 0; c < all.cols(); ++c) {
      const double size = all.col(c).cwiseAbs().maxCoeff();
      EXPECT_NEAR(all.col(c).mean(), 0, 1e-12 * size);
      EXPECT_NEAR(first(first.rows() - 1, c), motion.later(s, c), 1e-9 * size);
    }
    EXPECT_EQ(motion.Rows(s, 100, 7).row(99), all.row(693));
  }
}

// Of a window that begins when it has gone nothing is left.
TEST(StartState, IsGoneInALateWindow) {
  const Vehicle vehicle = ShippedVehicle("single_wheel_station");
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const FreeMotion motion = FreeMotionOf(LongHistory(vehicle, 6000), model);
  for (const Eigen::MatrixXd& first : motion.first) EXPECT_EQ(first.rows(), 0);
  EXPECT_EQ(motion.later.cwiseAbs().maxCoeff(), 0);
}

}  // namespace
}  // namespace fourpost::start_state_test
