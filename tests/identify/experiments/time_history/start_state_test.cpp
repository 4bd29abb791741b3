#include "identify/experiments/time_history/start_state.h"

#include <memory>
#include <string>

#include <gmock/gmock.h>

#include "identify/experiments/time_history/history_misfits.h"
#include "identify/experiments/time_history/history_residuals.h"
#include "tests/identify/recorded_station.h"
#include "tests/temporary_folder.h"

namespace fourpost {
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
}

}  // namespace
}  // namespace fourpost
