#include "vehicles/requests/history_files.h"

#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "vehicles/requests/findings.h"

namespace fourpost::history_files_test {
namespace {

using Json = nlohmann::json;

const TimeHistory& Example() {
  static const TimeHistory history{.start_s = 1,
                                   .rate_Hz = 10,
                                   .posts = Eigen::MatrixXd::Constant(3, 1, 0.012345678912),
                                   .readings = Eigen::Vector3d(1, -3, 2)};
  return history;
}

Vehicle Car() {
  Vehicle vehicle;
  vehicle.name = "car";
  vehicle.posts.emplace_back().name = "FL";
  vehicle.sensors = {{.name = "a", .type = Sensor::Type::kAccelerometer}};
  return vehicle;
}

TEST(HistoryFiles, TellPostsAndSensorsAtEightDigits) {
  EXPECT_EQ(HistoryCsv(Example(), ChannelsOf(Car(), Example(), {0})),
            "time,post_FL,a\ns,m,m/s^2\n1,0.012345679,1\n1.1,0.012345679,-3\n1.2,0.012345679,2\n");
}

TEST(HistoryFiles, TellHowLargeChannelsAreAndWhatIsKnownOfTheError) {
  HistoryOrigin origin{.motion = "step", .seed = 3, .error = 1e-3};
  Diagnostics findings;
  findings.Report(kBodiesBend, Place::Option("--sweep"), {"25 Hz"});
  const auto json = [&] {
    return Json::parse(HistoryJson(Car(), origin, Example(), ChannelsOf(Car(), Example(), {0}), findings));
  };
  EXPECT_TRUE(json()["integration"]["change_by_last_halving"].is_null());
  EXPECT_TRUE(json()["linear_kinematics_error"].is_null());
  origin.by.change = 2e-4;
  origin.by.step_s = 1e-3;
  origin.by.engine = Engine::kFull;
  origin.by.kinematics_error = HistoryDifference{.share = 0.046, .channel = "a"};
  const Json out = json();
  EXPECT_EQ(out["engine"], "full");
  EXPECT_EQ(out["linear_kinematics_error"]["value"], 0.046);
  EXPECT_EQ(out["linear_kinematics_error"]["channel"], "a");
  EXPECT_EQ(out["integration"]["change_by_last_halving"], 2e-4);
  EXPECT_EQ(out["integration"]["error_asked"], 1e-3);
  EXPECT_EQ(out["motion"], "step");
  EXPECT_EQ(out["findings"].size(), 1u);
  const Json& a = out["channels"][1];
  EXPECT_EQ(a["mean"], 0);
  EXPECT_EQ(a["peak"], 3);
  EXPECT_EQ(a["peak_to_peak"], 5);
  EXPECT_DOUBLE_EQ(a["rms"], std::sqrt(14.0 / 3));
}

}  // namespace
}  // namespace fourpost::history_files_test
