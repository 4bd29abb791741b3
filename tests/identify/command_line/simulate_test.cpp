// `fourpost simulate` as a user meets it.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "analysis/files/csv.h"
#include "tests/identify/program.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using Json = nlohmann::json;

class Simulate : public ProgramTest {
 protected:
  Outcome Run(const std::string& vehicle, const std::string& options) const {
    return RunFile("urdf/" + vehicle + ".urdf", options);
  }

  Outcome RunFile(const std::string& vehicle, const std::string& options) const {
    return ProgramTest::Run("simulate " + vehicle + " " + options);
  }

  void ExpectRefused(const std::string& vehicle, const std::string& options, int code,
                     const std::string& message) const {
    const Outcome outcome = Run(vehicle, options);
    EXPECT_EQ(outcome.code, code) << options;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
  }

  static CsvTable Table(const std::string& text) {
    Diagnostics diagnostics;
    const std::optional<CsvTable> table = ParseCsv(text, "out", diagnostics, CsvHeader::kNamesAndUnits);
    EXPECT_EQ(diagnostics.Format(), "");
    return table.value();
  }

  static std::vector<double> Column(const CsvTable& table, const std::string& name) {
    Diagnostics diagnostics;
    return table.Numbers(table.FindColumn(name).value(), diagnostics);
  }
};

TEST_F(Simulate, WritesPostsAndChannelsWithUnits) {
  const Outcome outcome = Run("quarter_car", "--sine 2Hz --amplitude 5mm --duration 4s --rate 200Hz");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const CsvTable table = Table(outcome.out);
  EXPECT_EQ(table.rows(), 801u);
  EXPECT_EQ(table.names()[0], "time");
  EXPECT_EQ(table.units()[0], "s");
  EXPECT_THAT(table.names()[1], testing::StartsWith("post_"));
  EXPECT_EQ(table.units()[1], "m");
  EXPECT_GT(table.columns(), 3u);
  EXPECT_EQ(Column(table, "time")[200], 1);
  const std::vector<double> heights = Column(table, table.names()[1]);
  EXPECT_NEAR(*std::max_element(heights.begin(), heights.end()), 0.005, 1e-5);
}

TEST_F(Simulate, TellsASummaryAndTheChannelsAskedFor) {
  const Outcome outcome = RunFile("--channels a_cg,s_strut_rear urdf/landrover110_linkage.urdf",
                                  "--step 20mm --engine reduced --json -o history.csv --chart history.svg");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json summary = Json::parse(outcome.out);
  EXPECT_EQ(summary["engine"], "reduced");
  EXPECT_EQ(summary["samples"], 2501);
  EXPECT_LE(summary["integration"]["change_by_last_halving"], 1e-3);
  EXPECT_EQ(summary["integration"]["error_asked"], 1e-3);
  EXPECT_EQ(summary["motion"], "step of 20.0 mm in heave");
  ASSERT_EQ(summary["channels"].size(), 4u);
  EXPECT_EQ(summary["channels"][0]["name"], "post_front");
  EXPECT_EQ(summary["channels"][0]["peak"], 0.02);
  EXPECT_EQ(summary["channels"][2]["name"], "a_cg");
  EXPECT_EQ(summary["channels"][3]["unit"], "m");
  EXPECT_THAT(ReadText(folder_ / "history.svg"), HasSubstr("s_strut_rear [mm]"));
  const CsvTable table = Table(ReadText(folder_ / "history.csv"));
  EXPECT_THAT(table.names(), testing::ElementsAre("time", "post_front", "post_rear", "a_cg", "s_strut_rear"));
}

TEST_F(Simulate, AnswersAlikeByBothEngines) {
  const std::string options = "--sine 1.5Hz --amplitude 4mm --duration 3s --json --channels a_cg,F_tyre_front";
  const Json condensed = Json::parse(Run("landrover110_linkage", options + " --engine condensed").out);
  EXPECT_EQ(condensed["engine"], "reduced");
  const Json full = Json::parse(Run("landrover110_linkage", options + " --engine full").out);
  EXPECT_EQ(full["engine"], "full");
  EXPECT_LE(full["integration"]["change_by_last_halving"].get<double>(), 1e-3);
  for (std::size_t i = 2; i < 4; ++i) {
    const double ratio = condensed["channels"][i]["rms"].get<double>() / full["channels"][i]["rms"].get<double>();
    // The engines' promise, 0.075 dB.
    EXPECT_NEAR(ratio, 1, 0.009);
  }
}

// By default linear kinematics are checked: a few millimetres they may do, 50 mm they may not.
TEST_F(Simulate, ChoosesTheEngineByWhatShows) {
  const auto run = [&](const std::string& amplitude) {
    return "--sine 1.5Hz --amplitude " + amplitude + " --velocity 1m/s --acceleration 2g --duration 3s -o a.csv";
  };
  const Outcome small = Run("landrover110_linkage", run("0.5mm"));
  EXPECT_THAT(small.out, HasSubstr("below the visible limit (0.6 %): reduced model used"));
  const Outcome large = Run("landrover110_linkage", run("50mm"));
  EXPECT_THAT(large.out, HasSubstr("above the visible limit (0.6 %): full geometry used"));
  const Json answer = Json::parse(Run("landrover110_linkage", run("50mm") + " --json").out);
  EXPECT_EQ(answer["engine"], "full");
  EXPECT_GT(answer["linear_kinematics_error"]["value"].get<double>(), 0.006);
  EXPECT_LE(answer["integration"]["change_by_last_halving"].get<double>(), 1e-3);
}

TEST_F(Simulate, ReplaysWhatItWrote) {
  ASSERT_EQ(Run("landrover110_model3", "--road B --speed 72km/h --duration 6s --rate 1kHz -o a.csv").code, 2);
  ASSERT_EQ(Run("landrover110_model3", "--road B --speed 72km/h --duration 6s --rate 1000Hz -o a.csv").code, 0);
  const Outcome again = Run("landrover110_model3", "--recording a.csv --rate 1000Hz -o b.csv");
  ASSERT_EQ(again.code, 0) << again.err;
  const std::vector<double> first = Column(Table(ReadText(folder_ / "a.csv")), "a_body_FL");
  const std::vector<double> second = Column(Table(ReadText(folder_ / "b.csv")), "a_body_FL");
  ASSERT_EQ(first.size(), second.size());
  double difference = 0;
  double size = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    difference += std::pow(first[k] - second[k], 2);
    size += first[k] * first[k];
  }
  // Both integrations' 0.1 %, and a spline through every other of its samples.
  EXPECT_LT(std::sqrt(difference / size), 3e-3);
}

TEST_F(Simulate, DrawsRoadsAndNoiseByTheSeed) {
  for (const std::string motion : {"--random 3mm", "--road B --speed 20m/s", "--sine 2Hz --amplitude 3mm --noise 2%"}) {
    const std::string options = motion + " --duration 4s --filter 30Hz --order 4 --seed ";
    const std::string one = Run("quarter_car", options + "1").out;
    EXPECT_EQ(one, Run("quarter_car", options + "1").out) << motion;
    EXPECT_NE(one, Run("quarter_car", options + "2").out) << motion;
  }
}

TEST_F(Simulate, RefusesUsageItDoesNotKnow) {
  ExpectRefused("quarter_car", "", 2, "--sweep,--sine,--step,--random,--recording,--road");
  ExpectRefused("quarter_car", "--sine 2 --amplitude 5mm", 2,
                "--sine: error: '2' is not a frequency: write a number with its unit");
  ExpectRefused("quarter_car", "--sine 2rad/s --amplitude 5mm", 2,
                "'2rad/s' is not a frequency: write a number with its unit");
  ExpectRefused("quarter_car", "--sine 2Hz --amplitude 5mm -o a.csv --chart a.csv", 5, "name the same file");
  ExpectRefused("quarter_car", "--sine 2Hz --amplitude 5N", 2, "--amplitude: error: '5N' is not a length");
  ExpectRefused("quarter_car", "--sine 2Hz --amplitude=-5mm", 2, "'-5mm' must be above zero");
  ExpectRefused("quarter_car", "--sweep 2Hz --amplitude 5mm", 2, "'2Hz' is not a range of frequencies");
  ExpectRefused("quarter_car", "--sine 2Hz --amplitude 5mm --mode hevae", 2, "did you mean 'heave'?");
  ExpectRefused("quarter_car", "--road I --speed 10m/s", 2, "--road: error: 'I' ");
  ExpectRefused("quarter_car", "--random 5mm --band 9Hz:3Hz", 2, "from a lower frequency to a higher one");
  ExpectRefused("quarter_car", "--step 5mm --seed -1", 2, "--seed");
  ExpectRefused("quarter_car", "--step 5mm --noise 1", 2, "--noise: error: '1' is not a share: write it in percent");
  ExpectRefused("quarter_car", "--step 5mm --noise 500%", 2, "'500%' must not be above 100%");
  ExpectRefused("quarter_car", "--step 5mm --chart x.png", 2, "'x.svg' [output-ending]");
  ExpectRefused("quarter_car", "--step 5mm --duration 0.4s", 2, "--duration: error: 0.4 s end before the step does");
  ExpectRefused("quarter_car", "--sine 2Hz --engine ful", 2, "did you mean 'full'?");
  ExpectRefused("quarter_car", "--stepp 5mm", 2, "did you mean '--step'?");
}

TEST_F(Simulate, TellsFaultsOfOptionsAtOnce) {
  for (const char* message :
       {"did you mean 'heave'?", "--sine: error: '5' is not a frequency", "'5mn' is not a length",
        "did you mean 'a_sprung'?", "the vehicle has no parameter 'm_sprun', did you mean 'm_sprung'?",
        "--noise: error: '1' is not a share"})
    ExpectRefused("quarter_car", "--mode heav --sine 5 --amplitude 5mn --channels a_spring --set m_sprun=1kg --noise 1",
                  2, message);
}

TEST_F(Simulate, TakesShareOfPostsAndOtherValuesOfParameters) {
  const std::string sine = "--sine 2Hz --duration 3s --json ";
  const Json plain = Json::parse(Run("landrover110_model3", sine).out);
  const Json outcome = Json::parse(Run("landrover110_model3", sine + "--mode FL=1,RR=-0.5 --set k_FL=50kN/m").out);
  EXPECT_EQ(outcome["parameters"]["k_FL"], 50e3);
  const double peak = outcome["channels"][0]["peak"];
  EXPECT_EQ(peak, plain["channels"][0]["peak"]);
  EXPECT_EQ(outcome["channels"][1]["peak"], 0);
  EXPECT_NEAR(outcome["channels"][3]["peak"], 0.5 * peak, 1e-12 * peak);  // rounding
}

// 0.15 m/s at 2 Hz: what `response` takes without a word.
TEST_F(Simulate, MovesThePostsWithinTheUsualLimits) {
  const Json sine = Json::parse(Run("quarter_car", "--sine 2Hz --duration 4s --json").out);
  EXPECT_NEAR(sine["channels"][0]["peak"], 0.15 / (4 * 3.14159265), 1e-4 * 0.012);  // of 500 samples a second
  const Json fast =
      Json::parse(Run("quarter_car", "--sine 10Hz --acceleration 0.5g --duration 4s --rate 2000Hz --json").out);
  EXPECT_NEAR(fast["channels"][0]["peak"], 0.5 * 9.80665 / std::pow(20 * 3.14159265, 2), 1e-5);
}

TEST_F(Simulate, WarnsOfFrictionThatNeverSlides) {
  ReplaceIn("urdf/quarter_car.urdf", "<bilinear bump=\"$c_bump\" rebound=\"$c_rebound\"/>",
            "<bilinear bump=\"$c_bump\" rebound=\"$c_rebound\"/><friction force=\"5 kN\"/>");
  for (const char* motion : {"--sine 2Hz --amplitude 1mm", "--road A --speed 5m/s --duration 4s", "--step 2mm"}) {
    const Outcome outcome = Run("quarter_car", std::string(motion) + " --json");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("'damper'"), HasSubstr(" 5000 N "), HasSubstr("[friction-holds]")))
        << motion;
    EXPECT_EQ(Json::parse(outcome.out)["findings"].size(), 1u);
  }
  ReplaceIn("urdf/quarter_car.urdf", "force=\"5 kN\"", "force=\"50 N\"");
  EXPECT_EQ(Run("quarter_car", "--sine 2Hz -o a.csv").err, "");
}

// Only where the file asks for it; both engines.
TEST_F(Simulate, WarnsOfATyreThatPulls) {
  const std::string road = "--road D --speed 60km/h --duration 4s --json";
  for (const std::string engine : {"", " --engine full"}) {
    const Outcome lifting = Run("quarter_car", road + engine);
    EXPECT_EQ(lifting.code, 0);
    EXPECT_EQ(lifting.err, "");
  }
  ReplaceIn("urdf/quarter_car.urdf", "stiffness=\"$kt\"", "stiffness=\"$kt\" liftoff=\"false\"");
  for (const std::string engine : {"", " --engine full"}) {
    const Outcome linear = Run("quarter_car", road + engine);
    EXPECT_EQ(linear.code, 0);
    EXPECT_THAT(linear.err, ContainsRegex("warning: fp:tyre 'tyre' pulls on the ground in [0-9]+ of 2001 samples of "
                                          "this motion, down to -[0-9.]+ N: remove liftoff=\"false\" or reduce the "
                                          "motion"));
    EXPECT_EQ(Json::parse(linear.out)["findings"].size(), 1u);
  }
  EXPECT_EQ(Run("quarter_car", "--sine 2Hz --amplitude 1mm -o a.csv").err, "");
}

TEST_F(Simulate, WarnsAboveTheModelsRange) {
  EXPECT_THAT(Run("quarter_car", "--sweep 1Hz:60Hz --duration 4s").err, HasSubstr("--sweep: warning: above 30 Hz"));
  EXPECT_THAT(Run("quarter_car", "--random 1mm --band 1Hz:60Hz --duration 4s").err,
              HasSubstr("--band: warning: above 30 Hz"));
  EXPECT_EQ(Run("quarter_car", "--sweep 1Hz:30Hz --duration 4s").err, "");
}

TEST_F(Simulate, AnInterruptedHistoryKeepsWhatItHas) {
  const Outcome outcome =
      RunShell(std::string("timeout --preserve-status -s INT 2 '") + FOURPOST_PROGRAM +
               "' simulate urdf/landrover110_linkage.urdf --sine 1Hz --duration 2000s --engine full "
               "-o history.csv --json");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("[history-interrupted]"));
  const Json summary = Json::parse(outcome.out);
  EXPECT_TRUE(summary["interrupted"]);
  const CsvTable table = Table(ReadText(folder_ / "history.csv"));
  EXPECT_EQ(table.rows(), summary["samples"]);
  EXPECT_GT(table.rows(), 100u);
  EXPECT_LT(table.rows(), 1000000u);
}

TEST_F(Simulate, RefusesWhatTheVehicleCannotDo) {
  ExpectRefused("quarter_car", "--sine 2Hz --amplitude 5mm --mode roll", 2, "the posts cannot make 'roll'");
  ExpectRefused("landrover110_linkage", "--sine 2Hz --amplitude 5mm --channels a_cgg", 2,
                "the vehicle has no sensor 'a_cgg', did you mean 'a_cg'?");
  ExpectRefused("landrover110_linkage", "--sine 1Hz --amplitude 80mm", 3,
                "fp:post 'front' reaches 75 mm up and down, but this motion needs 80 mm");
  EXPECT_EQ(Run("landrover110_linkage", "--sine 1Hz --amplitude 80mm --stroke 200mm").code, 0);
  ExpectRefused("quarter_car", "--sweep 1Hz:40Hz --amplitude 1mm --rate 100Hz", 2,
                "use 102.4 Hz or more [rate-too-low]");
  ExpectRefused("quarter_car", "--step 5mm --filter 300Hz", 2, "[filter-too-high]");
  ExpectRefused("quarter_car", "--step 5mm --rate 1000000000Hz", 2,
                "20000000 samples: lower --duration or --rate [history-too-long]");
  ExpectRefused("quarter_car", "--random 1mm --band 1Hz:1.01Hz --duration 0.1s", 2, "[motion-impossible]");
}

TEST_F(Simulate, RefusesVehiclesWithoutEquilibrium) {
  const std::string broken =
      (std::filesystem::path(FOURPOST_SOURCE_DIR) / "tests/data/broken/preload_not_balanced.urdf").string();
  const Outcome outcome = RunFile(broken, "--step 5mm");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("preload_not_balanced.urdf:"));
}

TEST_F(Simulate, KeepsToTheStrokeThatTheFileTells) {
  ReplaceIn("urdf/quarter_car.urdf", "under=\"tyre\"", "under=\"tyre\" stroke=\"20 mm\"");
  const Outcome outcome = Run("quarter_car", "--sine 1Hz --amplitude 12mm");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("fp:post 'post' reaches 10 mm up and down, but this motion needs 12 mm"));
  EXPECT_EQ(Run("quarter_car", "--sine 1Hz --amplitude 8mm").code, 0);
}

TEST_F(Simulate, WarnsOfAVehicleThatFallsOver) {
  ReplaceIn("urdf/landrover110_linkage.urdf", "link=\"front_axle\" xyz=\"0.870 0 -0.075\" ",
            "link=\"front_axle\" xyz=\"0.870 0 -15\" ");
  const Outcome outcome = Run("landrover110_linkage", "--step 1mm --duration 1s");
  EXPECT_THAT(outcome.err, HasSubstr("[unstable-in-design-pose]"));
}

// A rod thicker than its piston, which the file's own is not.
TEST_F(Simulate, RefusesValuesThatDoNotGoTogether) {
  const std::filesystem::path source(FOURPOST_SOURCE_DIR);
  const std::string thick = ReadText(source / "tests/data/broken/hydraulic_rod_too_thick.urdf");
  const std::string rod = "<fp:parameter name=\"rod\" value=\"11 mm\" source=\"estimate\"/>";
  temporary_.Write("urdf/corner.urdf", Replace(Replace(thick, "rod=\"4 cm\"/>", "rod=\"$rod\"/>"),
                                               "<fp:parameter name=\"k\"", rod + "<fp:parameter name=\"k\""));
  ASSERT_EQ(Run("corner", "--step 1mm --duration 1s").code, 0) << Run("corner", "--step 1mm").err;
  ExpectRefused("corner", "--step 1mm --set rod=40mm", 2, "[values-inconsistent]");
  for (const char* command : {"modes", "response"}) {
    const Outcome outcome = ProgramTest::Run(std::string(command) + " urdf/corner.urdf --set rod=40mm");
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("--set: error: "), HasSubstr("[values-inconsistent]")));
  }
}

TEST_F(Simulate, SaysWhereARecordingEnds) {
  ASSERT_EQ(Run("quarter_car", "--step 5mm --duration 2s -o a.csv").code, 0);
  EXPECT_THAT(Run("quarter_car", "--recording a.csv --duration 3s").err,
              AllOf(HasSubstr("--duration: warning: "), HasSubstr(" 2 s"), HasSubstr("[recording-ends]")));
  EXPECT_EQ(Run("quarter_car", "--recording a.csv --duration 2s").err, "");
  ExpectRefused("quarter_car", "--recording urdf/quarter_car.urdf", 3, "give a recording (.csv, .mat, ");
}

TEST_F(Simulate, TellsTheFaultsOfARecording) {
  temporary_.Write("posts.csv", "time,post\ns,kN\n0,1\n0.1,2\n0.2,\n0.3,1\n");
  ExpectRefused("quarter_car", "--recording posts.csv", 3, "posts.csv:");
  ExpectRefused("quarter_car", "--recording nowhere.csv", 3, "nowhere.csv");
}

TEST_F(Simulate, DoesNotWriteOverItsInputsNorIntoNothing) {
  const Outcome outcome = Run("quarter_car", "--step 5mm -o urdf/quarter_car.urdf");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("[output-is-input]"));
  EXPECT_EQ(Run("quarter_car", "--step 5mm -o nowhere/history.csv").code, 5);
  EXPECT_EQ(Run("quarter_car", "--step 5mm -o .").code, 5);
}

}  // namespace
}  // namespace fourpost
