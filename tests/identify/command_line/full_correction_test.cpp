// A fit of a time history whose motion linear kinematics do not show, by the program.
#include <cmath>
#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/program.h"
#include "tests/vehicles/ride_vehicles.h"

namespace fourpost {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

constexpr const char* kParameters = R"(
  <fp:parameter name="k" value="100 N/mm" lower="40 N/mm" upper="160 N/mm" precision="0.01 N/mm" source="estimate"/>
  <fp:parameter name="c" value="3 kN*s/m" lower="0.5 kN*s/m" upper="8 kN*s/m" precision="1 N*s/m" source="estimate"/>
  <fp:frame name="coil_top")";

constexpr const char* kStudy = R"(vehicle: arm.urdf
histories:
  - file: sine.csv
    posts: {post: post_post}
    channels: {a_chassis: a_chassis, s_coil: s_coil, F_tyre: F_tyre}
    noise: {a_chassis: 0.01 m/s^2, s_coil: 0.1 mm, F_tyre: 10 N}
search: {evaluations: 20, starts: 1}
)";

/// A trailing arm on a sine of 60 mm that the full geometry answered: linear kinematics are off by 0.45 % rms.
class FullCorrection : public ProgramTest {
 protected:
  FullCorrection() {
    std::string arm = Replace(SensedTrailingArm(), "\"80 N/mm\"", "\"$k\"");
    arm = Replace(arm, "2 kN*s/m", "$c");
    temporary_.Write("arm.urdf", Replace(arm, "\n  <fp:frame name=\"coil_top\"", kParameters));
    temporary_.Write("study.yaml", kStudy);
    const Outcome outcome =
        Run("simulate arm.urdf --set k=80N/mm --set c=2kN*s/m --sine 1.2Hz --amplitude 60mm --velocity 1m/s "
            "--duration 6s --rate 200Hz --engine full -o sine.csv");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }

  Json Result(const std::string& folder) const { return Json::parse(ReadText(folder_ / folder / "result.json")); }
};

// Without corrections the spring is 0.33 % off.
TEST_F(FullCorrection, FindsTheValuesThatTheFullGeometryWasGiven) {
  const Outcome outcome = Run("fit study.yaml -o run");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json result = Result("run");
  // What the integration's error of 0.1 % leaves.
  EXPECT_NEAR(result["parameters"][0]["value"].get<double>() / 80e3, 1, 5e-4);
  EXPECT_NEAR(result["parameters"][1]["value"].get<double>() / 2e3, 1, 5e-3);
  const Json& history = result["histories"][0];
  EXPECT_EQ(history["engine"], "full by correction");
  EXPECT_LT(history["correction_change"], 1e-3);
  EXPECT_GT(history["linear_kinematics_error"]["value"], 3e-3);
  EXPECT_THAT(outcome.out, HasSubstr("correct"));
}

TEST_F(FullCorrection, GoesOnFromItsArchiveWithoutPaying) {
  ASSERT_EQ(Run("fit study.yaml -o run").code, 0);
  const Json first = Result("run");
  const Outcome resumed = Run("fit study.yaml -o run --resume");
  ASSERT_EQ(resumed.code, 0);
  // A line for each round.
  const std::regex line("(\\d+) of (\\d+) evaluations come from run/archive\\.sqlite");
  int restored = 0;
  for (std::sregex_iterator found(resumed.err.begin(), resumed.err.end(), line), end; found != end; ++found) {
    EXPECT_EQ((*found)[1], (*found)[2]);
    restored += std::stoi((*found)[1]);
  }
  EXPECT_EQ(restored, first["evaluations"]["paid"]);
  const Json again = Result("run");
  EXPECT_EQ(again["parameters"], first["parameters"]);
  EXPECT_EQ(again["histories"], first["histories"]);
}

}  // namespace
}  // namespace fourpost
