// The program as a user meets it: arguments in, text, files and exit code out.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/archive_copy.h"
#include "tests/identify/program.h"
#include "tests/identify/running_program.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using Json = nlohmann::json;

constexpr const char* kVehicle = "urdf/landrover110_linkage.urdf";
constexpr const char* kStudy = "studies/landrover110/model2.yaml";

class CommandLine : public ProgramTest {
 protected:
  /// A fit that must fail for its input, with this message, and leave nothing behind.
  void ExpectRefused(const std::string& message) const {
    const Outcome outcome = Run("fit --no-suggest studies/landrover110/model2.yaml -o result");
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(fs::exists(folder_ / "result"));
  }
};

TEST_F(CommandLine, FitWritesItsResultAndCheckAcceptsTheFittedVehicle) {
  const Outcome fit = Run("fit --no-suggest studies/landrover110/model2.yaml -o result --seed 3 --threads 2");
  ASSERT_EQ(fit.code, 0) << fit.err;
  EXPECT_THAT(fit.out, HasSubstr("m_sprung"));
  EXPECT_THAT(fit.out, HasSubstr("rms dB"));
  EXPECT_THAT(fit.out, HasSubstr("\nrecording  rms dB  rms deg  NMSE, %\nbounce "));

  const Json result = Json::parse(ReadText(folder_ / "result/result.json"));
  EXPECT_EQ(result["termination"], "converged");
  EXPECT_EQ(result["seed"], 3);
  ASSERT_EQ(result["recordings"].size(), 2U);
  EXPECT_EQ(result["recordings"][1]["name"], "pitch");
  EXPECT_GT(result["recordings"][1]["nmse_percent"], 0);
  EXPECT_GT(result["cost"], 0);
  EXPECT_GT(result["evaluations"]["paid"], 300);
  EXPECT_EQ(result["evaluations"]["failed"], 0);
  // The objective is smooth enough for every refinement to find the one optimum.
  EXPECT_EQ(result["starts"]["agreeing"], result["starts"]["refined"]);
  EXPECT_EQ(result["starts"]["runs"][0]["agrees"], true);
  EXPECT_TRUE(result["evaluations"].contains("reused"));
  EXPECT_EQ(result["parameters"].size(), 12u);
  for (const Json& parameter : result["parameters"]) {
    EXPECT_GE(parameter["value"], parameter["lower"]);
    EXPECT_LE(parameter["value"], parameter["upper"]);
    EXPECT_TRUE(parameter["sd"].is_number()) << parameter;
    EXPECT_TRUE(parameter["at_bound"].is_boolean());
  }
  EXPECT_EQ(result["parameters"][0]["unit"], "kg");
  EXPECT_EQ(result["channels"].size(), 11u);
  EXPECT_TRUE(result["versions"].contains("simbody"));

  const std::string table = ReadText(folder_ / "result/response.csv");
  // Two recordings of 64 frequencies, 11 channels, and the header.
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2 * 64 * 11 + 1);
  EXPECT_THAT(ReadText(folder_ / "result/response.svg"), testing::StartsWith("<svg"));

  const Outcome check = Run("check result/vehicle.urdf --json");
  ASSERT_EQ(check.code, 0) << check.err;
  EXPECT_EQ(check.err, "");
  for (const Json& parameter : Json::parse(check.out)["parameters"])
    for (const Json& fitted : result["parameters"]) {
      if (fitted["name"] != parameter["name"]) continue;
      EXPECT_EQ(parameter["value"], fitted["value"]);
    }
}

TEST_F(CommandLine, FitTellsWhichParametersEndFarFromTheirPriors) {
  ReplaceIn(kVehicle, "value=\"1725 kg\"", "value=\"1725 kg\" prior_sd=\"10 kg\"");
  const Outcome fit = Run("fit --no-suggest studies/landrover110/model2.yaml -o result --threads 2");
  ASSERT_EQ(fit.code, 0) << fit.err;
  EXPECT_THAT(fit.out, testing::ContainsRegex("m_sprung .* kg .* [3-9]\\.[0-9] sd from prior\n"));
  EXPECT_THAT(fit.out, HasSubstr(" for 2551 residuals, of which priors "));
  const Json result = Json::parse(ReadText(folder_ / "result/result.json"));
  const Json& mass = result["parameters"][0];
  EXPECT_EQ(mass["prior"]["value"], 1725);
  EXPECT_EQ(mass["prior"]["sd"], 10);
  EXPECT_LT(mass["sd_parts"]["noise"], 10);
  EXPECT_LE(mass["sd_parts"]["model"], 10.1);
  for (std::size_t i = 1; i < 12; ++i) EXPECT_FALSE(result["parameters"][i].contains("prior"));
  // The fitted value is no prior.
  EXPECT_THAT(ReadText(folder_ / "result/vehicle.urdf"), testing::Not(HasSubstr("prior_sd")));
  EXPECT_EQ(Run("check result/vehicle.urdf").code, 0);
}

TEST_F(CommandLine, FitIsTheSameForOneAndTwoThreads) {
  const Outcome one = Run("fit studies/landrover110/model2.yaml -o one --threads 1 --json");
  const Outcome two = Run("fit studies/landrover110/model2.yaml -o two --threads 2 --json");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.out, two.out);
  EXPECT_EQ(one.out, ReadText(folder_ / "one/result.json"));
  EXPECT_EQ(ReadText(folder_ / "one/vehicle.urdf"), ReadText(folder_ / "two/vehicle.urdf"));
  EXPECT_EQ(ReadText(folder_ / "one/response.csv"), ReadText(folder_ / "two/response.csv"));
}

TEST_F(CommandLine, CheckTellsLoadsAndModes) {
  const Outcome outcome = Run("check urdf/quarter_car.urdf --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json check = Json::parse(outcome.out);
  EXPECT_EQ(check["dof"], 2);
  EXPECT_EQ(check["mobility"]["joint_coordinates"], 2);
  EXPECT_EQ(check["mass_kg"], 222);
  EXPECT_NEAR(check["unsprung_mass_kg"].get<double>(), 22, 1e-6);
  EXPECT_NEAR(check["corners"][0]["load_N"].get<double>(), 222 * 9.80665, 1e-9);
  EXPECT_NEAR(check["corners"][0]["alone"]["wheel_rate_N_per_m"].get<double>(), 15e3, 1e-3);
  EXPECT_NEAR(check["struts"][0]["motion_ratio_alone"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(check["modes"][0]["frequency_Hz"].get<double>(), 1.3647, 0.5e-4);  // specification 1.1
  EXPECT_NEAR(check["modes"][1]["damping_ratio"].get<double>(), 0.333, 0.5e-3);
  EXPECT_EQ(check["modes"][1]["name"], "wheel hop");
  EXPECT_EQ(check["observability"].size(), 6u);
}

TEST_F(CommandLine, CheckTellsPostsSensorsAndPriors) {
  ReplaceIn("urdf/quarter_car.urdf",
            "precision=\"0.01 kN/m\"\n                source=\"thesis section 4.2, quarter car example\"/>\n  "
            "<fp:parameter name=\"kt\"",
            "precision=\"0.01 kN/m\" prior_sd=\"700 N/m\"\n                source=\"thesis section 4.2, quarter car "
            "example\"/>\n  <fp:parameter name=\"kt\"");
  const Outcome text = Run("check urdf/quarter_car.urdf");
  ASSERT_EQ(text.code, 0) << text.err;
  for (const char* part : {"post  under tyre", "sensor", "accelerometer", "a_sprung", "prior sd", " 0.7 "})
    EXPECT_THAT(text.out, HasSubstr(part));
  const Json check = Json::parse(Run("check urdf/quarter_car.urdf --json").out);
  EXPECT_EQ(check["findings"], Json::array());
  EXPECT_EQ(check["posts"][0]["tyre"], "tyre");
  EXPECT_EQ(check["sensors"][0]["name"], "a_sprung");
  EXPECT_EQ(check["sensors"][0]["kind"], "accelerometer");
  EXPECT_EQ(check["sensors"][0]["link"], "sprung");
  EXPECT_EQ(check["parameters"][2]["prior_sd"], 700);
  EXPECT_EQ(check["parameters"][2]["precision"], 10);
  EXPECT_EQ(check["bushings"], Json::array());
  // The leading arm's bush as the file gives it, with a loss factor of 0.1 at 30 Hz.
  const Json arm = Json::parse(Run("check urdf/landrover110.urdf --json").out)["bushings"][0];
  EXPECT_EQ(arm["name"], "arm_FL");
  EXPECT_EQ(arm["stiffness_N_per_m"], Json({10e6, 1.5e6, 250e3}));
  EXPECT_EQ(arm["rotational_stiffness_Nm_per_rad"], Json({1000.0, 100.0, 1000.0}));
  EXPECT_NEAR(arm["damping_Ns_per_m"][0].get<double>(), 0.1 * 10e6 / (2 * std::numbers::pi * 30), 1e-9);  // rounding
}

TEST_F(CommandLine, CheckTellsWhatTheLinearModelLeavesOut) {
  ReplaceIn("urdf/quarter_car.urdf", "</robot>",
            "<fp:parameter name=\"gap\" value=\"60 mm\" lower=\"50 mm\" upper=\"70 mm\" precision=\"1 mm\" "
            "source=\"test\"/><fp:stop name=\"stop\" parent=\"sprung\" child=\"unsprung\"><bump gap=\"$gap\" "
            "stiffness=\"100 kN/m\"/></fp:stop></robot>");
  const Outcome outcome = Run("check urdf/quarter_car.urdf");
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("not in the linear model"));
}

TEST_F(CommandLine, CheckTellsAllOfOnePassAlsoInJson) {
  ReplaceIn("urdf/quarter_car.urdf", "value=\"230 kN/m\" lower=\"100 kN/m\"", "value=\"230 N/m\" lower=\"100 N/m\"");
  ReplaceIn("urdf/quarter_car.urdf", "<linear stiffness=\"$k\"", "<linear stiffness=\"$k\" preload=\"-9 N\"");
  const Outcome outcome = Run("check urdf/quarter_car.urdf --json");
  EXPECT_EQ(outcome.code, 3);
  const Json findings = Json::parse(outcome.out)["findings"];
  ASSERT_EQ(findings.size(), 2u) << findings;
  EXPECT_EQ(findings[0]["severity"], "warning");
  EXPECT_EQ(findings[0]["file"], "urdf/quarter_car.urdf");
  EXPECT_GT(findings[0]["line"], 0);
  EXPECT_THAT(findings[0]["text"].get<std::string>(), HasSubstr("was 230 kN/m meant?"));
  EXPECT_EQ(findings[1]["severity"], "error");
  for (const Json& finding : findings) EXPECT_THAT(outcome.err, HasSubstr(finding["text"].get<std::string>()));
}

TEST_F(CommandLine, CheckTellsInJsonWhyAFileDoesNotRead) {
  ReplaceIn("urdf/quarter_car.urdf", "<mass value=\"22\"/>", "<mass value=\"-22\"/>");
  const Outcome outcome = Run("check urdf/quarter_car.urdf --json");
  EXPECT_EQ(outcome.code, 3);
  const Json check = Json::parse(outcome.out);
  EXPECT_FALSE(check.contains("name"));
  ASSERT_GE(check["findings"].size(), 1u);
  EXPECT_EQ(check["findings"][0]["severity"], "error");
}

TEST_F(CommandLine, CheckPrintsTablesThatFitATerminal) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "urdf")) {
    if (entry.path().extension() != ".urdf") continue;
    const Outcome outcome = Run("check '" + entry.path().string() + "'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* part : {"motion ", "degrees of freedom", "centre of mass", "ride rate", "motion ratio",
                             "damping ratio", "source", "most sensitive"})
      EXPECT_THAT(outcome.out, HasSubstr(part)) << entry.path();
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 110u) << line;
      EXPECT_FALSE(line.ends_with(' ')) << line;
    }
  }
}

TEST_F(CommandLine, CheckResolvedPrintsAFileOfTheSameVehicle) {
  const Outcome resolved = RunShell(std::string("'") + FOURPOST_PROGRAM + "' check " + kVehicle + " --resolved");
  ASSERT_EQ(resolved.code, 0) << resolved.err;
  EXPECT_THAT(resolved.out, HasSubstr("preload=\"equilibrium\""));
  EXPECT_EQ(resolved.err, "");
  temporary_.Write("resolved.urdf", resolved.out);
  EXPECT_EQ(Run("check resolved.urdf --json").out, Run(std::string("check ") + kVehicle + " --json").out);
}

TEST_F(CommandLine, CheckWarnsOfWeightThatNoTyreCarries) {
  ReplaceIn(kVehicle, "</robot>",
            "<fp:frame name=\"hook\" link=\"ground\" xyz=\"-1.456 0 3\"/><fp:spring name=\"crane\" parent=\"hook\" "
            "child=\"chassis\"><linear stiffness=\"1 N/m\" preload=\"1 kN\"/></fp:spring></robot>");
  const Outcome outcome = Run(std::string("check ") + kVehicle);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("warning: the tyres carry "));
}

TEST_F(CommandLine, CheckWarnsOfMotionsThatNothingHolds) {
  ReplaceIn(
      "urdf/quarter_car.urdf", "</robot>",
      "<link name=\"disc\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
      "iyz=\"0\"/></inertial></link><joint name=\"spin\" type=\"continuous\"><parent link=\"unsprung\"/>"
      "<child link=\"disc\"/><axis xyz=\"0 1 0\"/></joint></robot>");
  const Outcome outcome = Run("check urdf/quarter_car.urdf");
  EXPECT_THAT(outcome.err, HasSubstr("nothing resists pitch of link 'disc'"));
  EXPECT_THAT(outcome.out, HasSubstr("wheel wind-up, free "));
}

TEST_F(CommandLine, CheckWarnsOfAnUnstableVehicle) {
  // A tyre's point far below an arm that turns: its load swings with the arm.
  ReplaceIn(kVehicle, "<fp:tyre name=\"front_tyre\" link=\"front_axle\" xyz=\"0.870 0 -0.075\"",
            "<fp:tyre name=\"front_tyre\" link=\"front_axle\" xyz=\"0.870 0 -15\"");
  const Outcome outcome = Run("check urdf/landrover110_linkage.urdf --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_FALSE(Json::parse(outcome.out)["stable"]);
  EXPECT_THAT(outcome.err, HasSubstr("[vehicle-unstable]"));
  EXPECT_EQ(Json::parse(outcome.out)["modes"][0]["kind"], "diverging");
  EXPECT_TRUE(Json::parse(Run("check urdf/quarter_car.urdf --json").out)["stable"]);
}

TEST_F(CommandLine, ResponseTellsTheMisfitOfTheVehicleAsItIs) {
  const Outcome text = Run("response studies/landrover110/model2.yaml");
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("a_axle_rear"));
  EXPECT_THAT(text.out, HasSubstr("\npitch "));
  const Json response = Json::parse(Run("response studies/landrover110/model2.yaml --json").out);
  EXPECT_EQ(response["recordings"].size(), 2u);
  EXPECT_EQ(response["channels"].size(), 11u);
  const Json& first = response["recordings"][0];
  EXPECT_EQ(first["channels"][0]["gain"].size(), first["frequency_Hz"].size());
}

TEST_F(CommandLine, ResponseComesFromTheEngineAskedFor) {
  ReplaceIn(kStudy, "[0.5 Hz, 12 Hz]", "[4 Hz, 4.15 Hz]");
  const Json linearised = Json::parse(Run("response studies/landrover110/model2.yaml --json").out)["recordings"];
  std::vector<Json> answers;
  for (const char* engine : {"full", "time"}) {
    const Outcome outcome = Run("response studies/landrover110/model2.yaml --json --engine " + std::string(engine));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json recordings = Json::parse(outcome.out)["recordings"];
    EXPECT_NE(recordings, linearised) << engine;
    answers.push_back(recordings);
    const double gain = recordings[0]["channels"][0]["gain"][0];
    const double expected = linearised[0]["channels"][0]["gain"][0];
    EXPECT_NEAR(gain / expected, 1, 0.006) << engine;  // 0.05 dB
  }
  EXPECT_NE(answers[0], answers[1]);
  const Outcome former = Run("response studies/landrover110/model2.yaml --json --engine march");
  EXPECT_THAT(former.err, HasSubstr("[engine-former]"));
  EXPECT_EQ(Json::parse(former.out)["recordings"], answers[1]);
}

// Dampers of a three-hundredth: pitch swings for minutes.
TEST_F(CommandLine, TellsWhatKeepsAMarchFromSettling) {
  ReplaceIn(kStudy, "[0.5 Hz, 12 Hz]", "[4 Hz, 4.15 Hz]");
  for (const std::string axle : {"front", "rear"}) {
    const std::string name = "name=\"c_" + axle;
    ReplaceIn(kVehicle, name + "_bump\" value=\"1500 N*s/m\" lower=\"500",
              name + "_bump\" value=\"5 N*s/m\" lower=\"1");
    ReplaceIn(kVehicle, name + "_rebound\" value=\"3500 N*s/m\" lower=\"1500",
              name + "_rebound\" value=\"5 N*s/m\" lower=\"1");
  }
  const Outcome outcome = Run("response studies/landrover110/model2.yaml --engine time");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("'bounce' has no periodic response at 4.00 Hz: heave at "));
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr(" within 60 s "), HasSubstr("give it damping"), HasSubstr("[response-unanswered]")));
}

/// One thing broken in the shipped data, which a fit must refuse.
struct BrokenInput {
  std::string name;
  fs::path file;
  std::string from;
  std::string to;
  std::string message;
};

std::ostream& operator<<(std::ostream& out, const BrokenInput& broken) { return out << broken.name; }

class RefusedInput : public CommandLine, public testing::WithParamInterface<BrokenInput> {};

TEST_P(RefusedInput, IsTold) {
  const BrokenInput& broken = GetParam();
  ReplaceIn(broken.file, broken.from, broken.to);
  ExpectRefused(broken.message);
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedInput,
    testing::Values(
        BrokenInput{"AMisspeltTag", kVehicle, "<fp:tyre name=\"front_tyre\"", "<fp:tire name=\"front_tyre\"",
                    "unknown tag"},
        BrokenInput{"AMisspeltAttribute", kVehicle, "stiffness=\"2*$k_front\"", "stifness=\"2*$k_front\"",
                    "did you mean 'stiffness'?"},
        BrokenInput{"AMissingUnit", kVehicle, "value=\"1725 kg\"", "value=\"1725\"",
                    "landrover110_linkage.urdf:88: error: value=\"1725\" of fp:parameter 'm_sprung' has no unit"},
        BrokenInput{"AnUnknownLink", kVehicle, "name=\"front_centre\" link=\"front_axle\"",
                    "name=\"front_centre\" link=\"frontaxle\"", "did you mean 'front_axle'?"},
        BrokenInput{"ALoopThatCannotBeClosed", kVehicle, "</robot>",
                    "<fp:frame name=\"far\" link=\"ground\" xyz=\"0 0.5 0\"/><fp:ball name=\"b\" parent=\"far\" "
                    "child=\"front_centre\"/>\n</robot>",
                    "the loop cannot be closed"},
        BrokenInput{"ANegativeMass", kVehicle, "<mass value=\"1725\"/>", "<mass value=\"-1725\"/>",
                    "must not be negative"},
        BrokenInput{"AMissingChannel", kStudy, "\n  a_cg: a_cg", "\n  a_cg: a_gc",
                    "has no channel 'a_gc', did you mean 'a_cg'?"},
        BrokenInput{"NaNInTheData", "studies/landrover110/bounce_frf.csv", "a_body_FL,1.01946", "a_body_FL,nan",
                    "bounce_frf.csv:2: error: "},
        BrokenInput{"AnEmptyBand", kStudy, "[0.5 Hz, 12 Hz]", "[0.1 Hz, 0.2 Hz]",
                    "the band holds no frequency of recording 'bounce'"},
        BrokenInput{"AnUnknownKey", kStudy, "\nsearch:", "\nsaerch:", "did you mean 'search'?"},
        BrokenInput{"AKeyThatStandsTwice", kStudy, "\nsearch:", "\nband: [1 Hz, 2 Hz]\nsearch:", "[key-twice]"}),
    [](const auto& test) { return test.param.name; });

TEST_F(CommandLine, TellsTheFaultsOfAllFilesAtOnce) {
  ReplaceIn(kVehicle, "value=\"1725 kg\"", "value=\"1725\"");
  ReplaceIn("studies/landrover110/bounce_frf.csv", "a_body_FL,1.01946", "a_body_FL,nan");
  ExpectRefused("bounce_frf.csv:2: error: ");
  ExpectRefused("landrover110_linkage.urdf:");
}

// Turning all of them round would not mend it.
TEST_F(CommandLine, WarnsOnceOfASumWithAMemberOfOppositeSign) {
  ReplaceIn(kStudy, "{sum: [F_tyre_FL, F_tyre_FR]}", "{sum: [F_tyre_FL, {channel: F_tyre_FR, sign: -1}]}");
  const Outcome outcome = Run("response studies/landrover110/model2.yaml");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, testing::StartsWith("studies/landrover110/model2.yaml:25: warning: 'F_tyre_FL' and "
                                               "'F_tyre_FR' of 'F_tyre_front' move against each other"));
  EXPECT_EQ(outcome.err.find("warning:", outcome.err.find("warning:") + 1), std::string::npos) << outcome.err;
}

TEST_F(CommandLine, CheckRefusesAFaultyVehicle) {
  ReplaceIn(kVehicle, "value=\"1725 kg\"", "value=\"1725\"");
  const Outcome outcome = Run("check urdf/landrover110_linkage.urdf --json");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("write \"1725 kg\""));
  EXPECT_EQ(Run("check urdf/landrover110_linkage.urdf").out, "");
}

TEST_F(CommandLine, RefusesUsageItDoesNotKnow) {
  for (const char* arguments :
       {"", "fitt", "fit", "check", "fit studies/landrover110/model2.yaml",
        "fit studies/landrover110/model2.yaml -o r --threads many",
        "fit studies/landrover110/model2.yaml -o r --seed -1", "fit studies/landrover110/model2.yaml -o r --seed 010",
        "response a.yaml --engine ful", "check a.urdf --jsn", "check a.urdf --json --resolved"})
    EXPECT_EQ(Run(arguments).code, 2) << arguments;
}

TEST_F(CommandLine, RefusesAMissingFile) {
  EXPECT_EQ(Run("check nowhere.urdf").code, 3);
  EXPECT_EQ(Run("response nowhere.yaml").code, 3);
}

TEST_F(CommandLine, DoesNotOverwriteWhatIsNotItsOwn) {
  fs::create_directories(folder_ / "thesis");
  std::ofstream(folder_ / "thesis/chapter1.tex") << "years of work";
  const Outcome outcome = Run("fit --no-suggest studies/landrover110/model2.yaml -o thesis");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("thesis"));
  EXPECT_EQ(ReadText(folder_ / "thesis/chapter1.tex"), "years of work");
}

TEST_F(CommandLine, ReplacesAnEarlierResult) {
  for (int run = 0; run < 2; ++run) EXPECT_EQ(Run("fit --no-suggest studies/landrover110/model2.yaml -o result").code, 0);
}

TEST_F(CommandLine, NamesTheStudysLineForAFileThatIsNotThere) {
  ReplaceIn(kStudy, "landrover110_linkage.urdf", "landrover.urdf");
  ExpectRefused("model2.yaml:3: error: file urdf/landrover.urdf does not exist");
}

TEST_F(CommandLine, DoesNotWriteOverItsInputs) {
  const Outcome outcome = Run("fit studies/landrover110/model2.yaml -o studies/landrover110");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("holds the input model2.yaml"));
}

TEST_F(CommandLine, TellsWhenStdoutIsFull) { EXPECT_EQ(Run("check urdf/quarter_car.urdf --json >/dev/full").code, 5); }

TEST_F(CommandLine, AnInterruptedFitKeepsTheBestSoFar) {
  ReplaceIn(kStudy, "  evaluations: 100\n", "  evaluations: 100000000\n  generations: 1000000\n");
  RunningProgram program(folder_, "fit --no-suggest studies/landrover110/model2.yaml -o result");
  // In the search, on any machine; twice, as timeout(1) does with the process and its group.
  while (program.IsRunning() && RowsOfCopy(folder_ / "result/archive.sqlite") < 25)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.Signal(SIGINT);
  program.Signal(SIGINT);
  const Outcome outcome = {program.Wait(), program.out(), program.err()};
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("fit interrupted"));
  EXPECT_THAT(outcome.out, HasSubstr("[ended-without-deviations]"));
  EXPECT_THAT(outcome.out, HasSubstr("stopped before any refinement ended\nsearch by dvhde stopped by the user: "));
  const Json result = Json::parse(ReadText(folder_ / "result/result.json"));
  EXPECT_EQ(result["termination"], "interrupted");
  EXPECT_TRUE(result["identifiability"].is_null());
  EXPECT_GT(result["residuals"], 1000);
  EXPECT_EQ(Run("check result/vehicle.urdf").code, 0);
}

TEST_F(CommandLine, SpeaksOfTheSignalThatEndsIt) {
  ReplaceIn(kStudy, "  evaluations: 100\n", "  evaluations: 100000000\n  generations: 1000000\n");
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string result = "result" + std::to_string(signal);
    RunningProgram program(folder_, "fit studies/landrover110/model2.yaml -o " + result);
    while (program.IsRunning() && RowsOfCopy(folder_ / result / "archive.sqlite") < 25)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    program.Signal(signal);
    EXPECT_EQ(program.Wait(), 130);
    EXPECT_EQ(program.err().find("Ctrl-C") != std::string::npos, signal == SIGINT) << program.err();
    EXPECT_THAT(program.err(), HasSubstr(signal == SIGINT ? "another Ctrl-C" : "another such signal"));
  }
}

TEST_F(CommandLine, FitTellsProfilesOfTheParametersAsked) {
  const Outcome fit = Run("fit --no-suggest studies/landrover110/model1.yaml -o result --profile k_front,m_front");
  EXPECT_EQ(fit.code, 0) << fit.err;
  EXPECT_THAT(fit.out, HasSubstr("95 % by profile"));
  const Json result = Json::parse(ReadText(folder_ / "result/result.json"));
  ASSERT_EQ(result.at("profiles").size(), 2u);
  for (const Json& profile : result.at("profiles")) {
    const Json& parameters = result.at("parameters");
    const auto same = std::find_if(parameters.begin(), parameters.end(),
                                   [&](const Json& parameter) { return parameter.at("name") == profile.at("name"); });
    // A profile sees noise alone.
    const double value = same->at("value");
    const double reach = 1.96 * same->at("sd_parts").at("noise").get<double>() / value;
    const double width = value * (std::exp(reach) - std::exp(-reach));
    // The model bends a little: a tenth.
    for (int end : {0, 1})
      EXPECT_NEAR(profile.at("interval_95")[end], value * std::exp(end == 0 ? -reach : reach), 0.1 * width)
          << profile.at("name");
  }
  EXPECT_THAT(ReadText(folder_ / "result/profile.svg"), HasSubstr("k_front, kN/m"));
  EXPECT_THAT(ReadText(folder_ / "result/report.html"), HasSubstr("95 % by profile"));

  const Outcome unknown = Run("fit studies/landrover110/model1.yaml -o other --profile k_frnt");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("the study frees no parameter 'k_frnt', did you mean 'k_front'?"));
  EXPECT_FALSE(fs::exists(folder_ / "other"));
}

TEST_F(CommandLine, AnswersHelpAndVersion) {
  EXPECT_THAT(Run("--help").out, HasSubstr("check"));
  EXPECT_THAT(Run("--version").out, HasSubstr("0.2.0"));
}

TEST_F(CommandLine, CompareCountsWhatEachMethodNeeds) {
  const Outcome outcome =
      Run("compare studies/test_problems/oscillator.yaml --methods dvhde,gb,de_15 --runs 5 --seed 3 --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Json methods = Json::parse(outcome.out).at("methods");
  ASSERT_EQ(methods.size(), 3u);
  for (const Json& method : methods) {
    EXPECT_EQ(method.at("runs"), 5);
    EXPECT_EQ(method.at("successes"), 5) << method.at("name");
    EXPECT_EQ(method.at("evaluations_mean"), method.at("expected_evaluations"));
    EXPECT_LE(method.at("cost_worst"), 1e-6);
  }
  EXPECT_EQ(methods[2].at("name"), "de_15");
  EXPECT_LT(methods[0].at("evaluations_mean"), 50);
  const std::string same =
      "compare studies/test_problems/oscillator.yaml --methods dvhde,gb,de_15 --runs 5 --seed 3 --json ";
  EXPECT_EQ(Run(same + "--threads 1").out, outcome.out);
  EXPECT_EQ(Run(same + "--threads 4").out, outcome.out);
}

TEST_F(CommandLine, ComparePrintsATableWithIntervalsAndAllSettings) {
  const Outcome outcome = Run("compare studies/test_problems/gear_train.yaml --methods thesis_40,simplex --runs 3");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("per success"));
  EXPECT_THAT(outcome.out, HasSubstr("95 %"));
  EXPECT_THAT(outcome.out, HasSubstr("thesis_40: ended by"));
  EXPECT_THAT(outcome.out,
              testing::ContainsRegex(
                  "thesis_40: ended by .*algorithm de; with population 40 .*base random .*factor 0.8 .*crossover 0.7"));
}

TEST_F(CommandLine, CompareTellsTimeAndEndsRunsWhereAsked) {
  const std::string compare = "compare studies/test_problems/gear_train.yaml --methods de --runs 2 --evaluations 60 ";
  const Outcome outcome = Run(compare + "--time --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Json method = Json::parse(outcome.out).at("methods").at(0);
  EXPECT_GT(method.at("seconds").at("mean"), 0);
  EXPECT_EQ(method.at("ends").at("evaluations used up"), 2);
  EXPECT_EQ(method.at("evaluations").at("mean"), 60);
  EXPECT_THAT(Run(compare + "--time").out, HasSubstr("seconds"));
  EXPECT_EQ(Run(compare + "--near 3").code, 2);
  EXPECT_EQ(Run(compare + "--time --archive a.sqlite").code, 2);
}

TEST_F(CommandLine, CompareTakesTheStudyOfAVehicle) {
  const Outcome outcome = Run("compare studies/landrover110/model2.yaml --methods gb,dvhde --runs 1 --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  // Without a target of its own, the best of all runs and 1 %.
  EXPECT_NEAR(json.at("target_cost"), 1.01 * 10535.5, 2);
  EXPECT_EQ(json.at("methods").at(0).at("successes"), 1);
}

TEST_F(CommandLine, CompareNamesWhatItDoesNotKnow) {
  const Outcome method = Run("compare studies/test_problems/gear_train.yaml --methods thesis_4");
  EXPECT_EQ(method.code, 2);
  EXPECT_EQ(method.err, "--methods: error: unknown method 'thesis_4', did you mean 'thesis_40'? [method-unknown]\n");
  EXPECT_EQ(method.out, "");
  const Outcome twice = Run("compare studies/test_problems/gear_train.yaml --methods de,de");
  EXPECT_EQ(twice.code, 2);
  EXPECT_THAT(twice.err, HasSubstr("[method-twice]"));
  ReplaceIn("studies/test_problems/gear_train.yaml", "problem: gear_train", "problem: gear_trains");
  const Outcome problem = Run("compare studies/test_problems/gear_train.yaml");
  EXPECT_EQ(problem.code, 3);
  EXPECT_THAT(problem.err,
              HasSubstr("gear_train.yaml:2: error: unknown problem 'gear_trains', did you mean 'gear_train'?"));
}

TEST_F(CommandLine, FitSendsATestProblemToCompare) {
  const Outcome outcome = Run("fit studies/test_problems/gear_train.yaml -o result");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("this is a test problem for `fourpost compare`"));
}

}  // namespace
}  // namespace fourpost
