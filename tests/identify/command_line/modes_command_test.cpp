// `fourpost modes` as a user meets it.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/program.h"

namespace fourpost {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class ModesCommandLine : public ProgramTest {};

TEST_F(ModesCommandLine, TellsPolesAndShapes) {
  const Outcome outcome = Run("modes urdf/quarter_car.urdf");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  // Poles of thesis section 4.2.
  for (const char* part : {"heave", "1.365", "0.401", "wheel hop", "16.44", "0.333", "0.210", "1.34", "0.0174", "0.134",
                           "sprung z 1", "unsprung z 1"})
    EXPECT_THAT(outcome.out, HasSubstr(part));
  const Json result = Json::parse(Run("modes urdf/quarter_car.urdf --json").out);
  ASSERT_EQ(result["modes"].size(), 2u);
  EXPECT_EQ(result["state_space"]["A"].size(), 4u);
  EXPECT_EQ(result["state_space"]["inputs"][0], "post");
  const Json& hop = result["modes"][1];
  EXPECT_EQ(hop["kind"], "oscillating");
  EXPECT_GT(hop["poles_per_s"][0][1], 90);
  EXPECT_LT(hop["damped_frequency_Hz"], hop["frequency_Hz"]);
  EXPECT_EQ(hop["shape"][0]["body"], "unsprung");
  EXPECT_NEAR(hop["shape"][0]["translation_m"][2][0].get<double>(), 1, 1e-12);  // rounding
}

TEST_F(ModesCommandLine, FollowsPolesAndDrawsThem) {
  const Outcome outcome = Run("modes urdf/quarter_car.urdf --vary k --vary c_bump=200N*s/m:4000N*s/m:7 -o result");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Hz at 5.000 kN/m"));
  const std::string table = ReadText(folder_ / "result/poles.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2 * 25 + 2 * 7 + 1);
  for (const char* picture : {"result/bode_k.svg", "result/bode_c_bump.svg", "result/impulse.svg"})
    EXPECT_THAT(ReadText(folder_ / picture), testing::StartsWith("<svg")) << picture;
  EXPECT_THAT(ReadText(folder_ / "result/impulse.csv"), testing::StartsWith("time,"));
  for (const char* picture : {"result/poles_k.svg", "result/poles_c_bump.svg"})
    EXPECT_THAT(ReadText(folder_ / picture), HasSubstr(">wheel hop<")) << picture;
  const Json result = Json::parse(ReadText(folder_ / "result/result.json"));
  EXPECT_EQ(result["pole_paths"][0]["parameter"], "k");
  EXPECT_EQ(result["pole_paths"][1]["values"].size(), 7u);
  EXPECT_EQ(result["pole_paths"][1]["paths"][0]["poles_per_s"].size(), 7u);
}

TEST_F(ModesCommandLine, TellsFaultsOfOptionsAtOnce) {
  const Outcome outcome =
      Run("modes urdf/quarter_car.urdf --vary m_unsprun --vary k=1kN/m --set m_sprun=2kg --set kt=5 -o result");
  EXPECT_EQ(outcome.code, 2);
  for (const char* part : {"--vary: error: the vehicle has no parameter 'm_unsprun', did you mean 'm_unsprung'?",
                           "[range-malformed]", "did you mean 'm_sprung'?", "[setting-unit]"})
    EXPECT_THAT(outcome.err, HasSubstr(part));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "result"));
}

TEST_F(ModesCommandLine, WarnsOfWhatGrows) {
  ReplaceIn("urdf/landrover110_linkage.urdf", "<fp:tyre name=\"front_tyre\" link=\"front_axle\" xyz=\"0.870 0 -0.075\"",
            "<fp:tyre name=\"front_tyre\" link=\"front_axle\" xyz=\"0.870 0 -15\"");
  const Outcome outcome = Run("modes urdf/landrover110_linkage.urdf");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("[unstable-in-design-pose]"));
  EXPECT_THAT(outcome.out, HasSubstr("diverging"));
}

TEST_F(ModesCommandLine, OfEveryShippedVehicleFitATerminal) {
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "urdf")) {
    if (entry.path().extension() != ".urdf") continue;
    const Outcome outcome = Run("modes '" + entry.path().string() + "'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << entry.path();
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;
  }
}

}  // namespace
}  // namespace fourpost
