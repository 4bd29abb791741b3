// `fourpost predict` of a whole car: warp, a road and a load. What stands for a fit's folder is the car as its file has
// it, with its study; recordings come from `fourpost response` and `fourpost simulate` of the same car.
#include <filesystem>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/program.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class PredictCar : public ProgramTest {
 protected:
  PredictCar() {
    std::filesystem::create_directory(folder_ / "run");
    std::filesystem::copy_file(folder_ / "urdf/landrover110_engine.urdf", folder_ / "run/vehicle.urdf");
    std::filesystem::copy_file(folder_ / "studies/landrover110/full.yaml", folder_ / "run/study.yaml");
    // Of a fit that has seen no recording.
    temporary_.Write("run/result.json", R"({"termination": "converged", "parameters": [], "fitted_files": []})");
  }

  /// A stepped sine as a rig writes it: without pattern and engine.
  void RecordSine(const std::string& options) const {
    const Outcome outcome = Run("response urdf/landrover110_engine.urdf --engine full -o response " + options);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(ReadText(folder_ / "response/response.csv"));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t first = line.find(',') + 1;
      text += line.substr(first, line.rfind(',') - first) + '\n';
    }
    temporary_.Write("sine.csv", text);
  }

  Json Predict(const std::string& options) const {
    const Outcome outcome = Run("predict run --json --recording " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

// In warp channels of the car's middle are next to nodes, where linear kinematics are visibly off.
TEST_F(PredictCar, PredictsWarpByTheFullGeometry) {
  RecordSine("--mode warp --frequencies 0.6Hz:10Hz:6");
  const Json told = Predict("sine.csv --mode warp");
  EXPECT_EQ(told["channels"].size(), 21U);
  EXPECT_EQ(told["engine"], "full");
  EXPECT_TRUE(told["linear_kinematics_error"]["visible"]);
  // Digits of the table.
  for (const Json& channel : told["channels"]) EXPECT_LT(channel["nmse_percent"], 1e-3) << channel;
  EXPECT_EQ(Predict("sine.csv")["posts"], "warp");
  const Json reduced = Predict("sine.csv --mode warp --engine reduced");
  EXPECT_EQ(reduced["engine"], "reduced");
  EXPECT_GT(reduced["channels"][4]["nmse_percent"], 0.1) << reduced["channels"][4];
  EXPECT_GT(Predict("sine.csv --mode heave")["channels"][0]["nmse_percent"], 10);
}

TEST_F(PredictCar, ForetellsARoadOnFourPosts) {
  for (const char* corner : {"FL", "FR", "RL", "RR"})
    ReplaceIn("run/study.yaml", std::string(corner) + ": z_post_" + corner, std::string(corner) + ": post_" + corner);
  const Outcome outcome =
      Run("simulate urdf/landrover110_engine.urdf --road B --speed 60km/h --duration 4s --filter 30Hz -o road.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json told = Predict("road.csv");
  EXPECT_EQ(told["channels"].size(), 21U);
  // The posts as they went through the filter, undone up to 45 Hz.
  for (const Json& channel : told["channels"]) EXPECT_LT(channel["nmse_percent"], 0.5) << channel;
}

TEST_F(PredictCar, CarriesALoadOnFourPosts) {
  RecordSine("--mode roll --frequencies 0.6Hz:10Hz:6");
  const Json load = Predict("sine.csv --mode roll --add-mass '200 kg' --at '-2,300 mm,1'")["added_load"];
  EXPECT_EQ(load["body"], "chassis");
  ASSERT_EQ(load["static_loads"].size(), 4U);
  double all = 0;
  double left = 0;
  for (const Json& post : load["static_loads"]) {
    const double more = post["with_N"].get<double>() - post["without_N"].get<double>();
    all += more;
    if (post["post"].get<std::string>().ends_with('L')) left += more;
  }
  EXPECT_NEAR(all, 200 * kGravity, 1e-6);  // rounding
  // By the lever over the track, 2 x 0.743 m.
  EXPECT_NEAR(left / all, 0.5 + 0.3 / (2 * 0.743), 1e-9);
}

}  // namespace
}  // namespace fourpost
