// `fourpost response` of a vehicle file as a user meets it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <numbers>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/program.h"
#include "tests/identify/running_program.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

constexpr const char* kCar = "urdf/quarter_car.urdf";

class ResponseCommandLine : public ProgramTest {
 protected:
  /// Replaces the last line of the quarter car.
  void Add(const std::string& tags) const { ReplaceIn(kCar, "</robot>", tags + "</robot>"); }

  /// 3: a file that cannot be used; 2: options.
  void ExpectRefused(const std::string& arguments, const std::string& message, int code = 3) const {
    const Outcome outcome = Run("response " + arguments + " -o result");
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "result"));
  }
};

TEST_F(ResponseCommandLine, OfAVehicleIsATableAndAFolder) {
  const Outcome outcome = Run("response urdf/quarter_car.urdf --frequencies 0.5Hz:20Hz:30 -o result");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "results: result\n");
  for (const char* part :
       {"heave: 30 frequencies from 0.5", "swept up, engine reduced\n", "at most 12 mm, 0.15 m/s, 6 m/s^2\n",
        "linear kinematics are off by at most", "a_sprung", "F_tyre"})
    EXPECT_THAT(outcome.out, HasSubstr(part));
  const std::string table = ReadText(folder_ / "result/response.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 30 * 6 + 1);
  EXPECT_THAT(ReadText(folder_ / "result/response.svg"), testing::StartsWith("<svg"));
  const Json result = Json::parse(ReadText(folder_ / "result/result.json"));
  EXPECT_EQ(result["vehicle"], "quarter_car");
  EXPECT_EQ(result["modes"][0]["posts"]["post"], 1);
  EXPECT_EQ(result["modes"][0]["channels"].size(), 6u);
  EXPECT_FALSE(result["modes"][0]["linear_kinematics_error"]["visible"]);
}

TEST_F(ResponseCommandLine, TellsModesChannelsAndSettingsAskedFor) {
  const Outcome outcome =
      Run("response urdf/landrover110_model3.urdf --mode roll --mode heave --channels a_cg,a_cg --frequencies 1Hz,2Hz "
          "--amplitude 3mm --set k_FL=50kN/m --direction down --engine reduced --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json result = Json::parse(outcome.out);
  ASSERT_EQ(result["modes"].size(), 2u);
  EXPECT_EQ(result["modes"][0]["mode"], "roll");
  EXPECT_EQ(result["modes"][1]["channels"].size(), 1u);
  EXPECT_EQ(result["modes"][1]["frequency_Hz"], Json({1, 2}));
  EXPECT_EQ(result["modes"][1]["post_amplitude_m"], Json({0.003, 0.003}));
  EXPECT_EQ(result["parameters"]["k_FL"], 50e3);
  EXPECT_EQ(result["direction"], "down");
}

TEST_F(ResponseCommandLine, TellsFaultsOfOptionsAtOnce) {
  const std::string options = " --mode heav --frequencies 5 --amplitude 5mn --channels a_spring --set m_sprun=1kg";
  for (const char* message :
       {"did you mean 'heave'?", "'5' is not a frequency", "'5mn' is not a length", "did you mean 'a_sprung'?",
        "the vehicle has no parameter 'm_sprun', did you mean 'm_sprung'?"})
    ExpectRefused(kCar + options, message, 2);
}

TEST_F(ResponseCommandLine, TellsOptionsThatAStudyDoesNotTake) {
  const std::string study = "studies/landrover110/model2.yaml --mode roll --amplitude 3mm";
  for (const char* part : {"--mode: error: ", "--amplitude: error: ", " model2.yaml ", "[option-of-vehicle]"})
    ExpectRefused(study, part, 2);
}

TEST_F(ResponseCommandLine, TellsFaultsOfTheFile) {
  ReplaceIn(kCar, "<mass value=\"22\"/>", "<mass value=\"-22\"/>");
  ExpectRefused(kCar, "must not be negative");
  ExpectRefused("nowhere.urdf", "nowhere.urdf");
}

TEST_F(ResponseCommandLine, TellsThatNothingHoldsTheDesignPose) {
  ReplaceIn(kCar, "<linear stiffness=\"$k\"", "<linear stiffness=\"$k\" preload=\"-9 N\"");
  ExpectRefused(kCar, "preload");
}

TEST_F(ResponseCommandLine, NamesTheModeThatGrows) {
  ReplaceIn("urdf/landrover110_linkage.urdf", "<fp:tyre name=\"front_tyre\" link=\"front_axle\" xyz=\"0.870 0 -0.075\"",
            "<fp:tyre name=\"front_tyre\" link=\"front_axle\" xyz=\"0.870 0 -15\"");
  ExpectRefused("urdf/landrover110_linkage.urdf", "[unstable]");
}

TEST_F(ResponseCommandLine, RefusesMoreThanTheStroke) {
  ReplaceIn(kCar, "<fp:post name=\"post\" under=\"tyre\"/>",
            "<fp:post name=\"post\" under=\"tyre\" stroke=\"80 mm\"/>");
  ExpectRefused(std::string(kCar) + " --amplitude 50mm",
                "fp:post 'post' reaches 40 mm up and down, but heave at 0.5 Hz needs 50 mm");
  EXPECT_EQ(Run(std::string("response ") + kCar).code, 0);
}

TEST_F(ResponseCommandLine, WarnsOfFrictionThatNeverSlides) {
  ReplaceIn(kCar, "<bilinear bump=\"$c_bump\" rebound=\"$c_rebound\"/>",
            "<bilinear bump=\"$c_bump\" rebound=\"$c_rebound\"/><friction force=\"5 kN\"/>");
  const Outcome outcome = Run(std::string("response ") + kCar + " --frequencies 1Hz:10Hz:5 --amplitude 1mm");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("'damper'"), HasSubstr(" heave"), HasSubstr(" 5000 N "), HasSubstr("[friction-holds]")));
}

TEST_F(ResponseCommandLine, WarnsOfATyreThatPulls) {
  const std::string sweep = std::string("response ") + kCar +
                            " --frequencies 1Hz:16Hz:5 --amplitude 15mm --velocity 2m/s "
                            "--acceleration 10g --engine reduced";
  EXPECT_THAT(Run(sweep).err, Not(HasSubstr("pulls on the ground")));
  ReplaceIn(kCar, "stiffness=\"$kt\"", "stiffness=\"$kt\" liftoff=\"false\"");
  EXPECT_THAT(Run(sweep).err,
              ContainsRegex("warning: fp:tyre 'tyre' pulls on the ground in [1-4] of 5 frequencies of heave, "
                            "down to -[0-9.]+ N: remove liftoff=\"false\" or reduce the motion"));
}

TEST_F(ResponseCommandLine, WarnsAboveTheModelsRange) {
  const Outcome outcome = Run(std::string("response ") + kCar + " --frequencies 1Hz:60Hz:5");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("warning: above 30 Hz"));
}

TEST_F(ResponseCommandLine, TellsWhichFrequenciesHaveNoSteadyMotion) {
  const Outcome outcome = Run(std::string("response ") + kCar +
                              " --frequencies 3Hz --engine time --set c_bump=1N*s/m --set c_rebound=1N*s/m -o none");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("outside its bounds"));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("heave: no answer at 1 of 1 "), HasSubstr("[frequencies-unanswered]")));
  EXPECT_THAT(outcome.out,
              HasSubstr("no answer at 3.00 Hz: heave at 3 Hz, 7.96 mm has no periodic motion within 60 s"));
  const Json result = Json::parse(ReadText(folder_ / "none/result.json"));
  EXPECT_THAT(result["modes"][0]["unanswered"][0]["why"].get<std::string>(),
              HasSubstr("no periodic motion within 60 s"));
  EXPECT_THAT(ReadText(folder_ / "none/response.svg"), Not(HasSubstr("nan")));
}

TEST_F(ResponseCommandLine, ShowsAllOfFewFrequenciesAndSpreadsTheColumnsOverMany) {
  const Outcome few = Run(std::string("response ") + kCar + " --frequencies 1Hz,1.1Hz,1.2Hz,1.3Hz,1.4Hz,9Hz");
  for (const char* column : {" 1.00 Hz", " 1.10 Hz", " 1.20 Hz", " 1.30 Hz", " 1.40 Hz", " 9.00 Hz"})
    EXPECT_THAT(few.out, HasSubstr(column));
  const Outcome many = Run(std::string("response ") + kCar + " --frequencies 2Hz:4Hz:50");
  const std::string head =
      many.out.substr(many.out.find("at Hz"), many.out.find('\n', many.out.find("at Hz")) - many.out.find("at Hz"));
  EXPECT_THAT(head, HasSubstr(" 2.00 Hz"));
  EXPECT_THAT(head, testing::EndsWith(" 4.00 Hz"));
  EXPECT_EQ(std::count(head.begin(), head.end(), 'H'), 9) << head;
}

TEST_F(ResponseCommandLine, EndsWith1WhereSomeFrequenciesHaveNoAnswer) {
  const Outcome outcome = Run(std::string("response ") + kCar +
                              " --frequencies 3Hz:30Hz:2 --engine time --set c_bump=20N*s/m --set c_rebound=20N*s/m");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("heave: no answer at 1 of 2 "), HasSubstr("[frequencies-unanswered]")));
}

TEST_F(ResponseCommandLine, AnInterruptedMarchKeepsWhatItHas) {
  RunningProgram program(
      folder_,
      "response urdf/landrover110_linkage.urdf --engine time --mode heave --mode pitch --frequencies "
      "1Hz:3Hz:4000 -o result");
  // Told with the rate: at least one frequency is done.
  while (program.IsRunning() && program.err().find(" per ") == std::string::npos)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  program.Signal(SIGINT);
  const Outcome outcome = {program.Wait(), program.out(), program.err()};
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("[response-interrupted]"));
  EXPECT_THAT(outcome.out, HasSubstr("[interrupted]\n"));
  const Json result = Json::parse(ReadText(folder_ / "result/result.json"));
  ASSERT_EQ(result["modes"].size(), 1u);
  EXPECT_FALSE(result["modes"][0]["channels"][0]["gain"][0].is_null());
  EXPECT_TRUE(result["modes"][0]["channels"][0]["gain"][3999].is_null());
}

TEST_F(ResponseCommandLine, TellsWhatKindOfFileItWasGiven) {
  ExpectRefused("studies", "a vehicle file (.urdf) or a study (.yaml) [file-of-other-kind]");
  ExpectRefused("studies/landrover110/bounce_frf.csv", "[file-of-other-kind]");
  EXPECT_THAT(Run("modes studies/landrover110/model2.yaml").err, HasSubstr("[study-for-vehicle]"));
  EXPECT_THAT(Run("fit urdf/quarter_car.urdf -o result").err, HasSubstr("[vehicle-for-study]"));
}

TEST_F(ResponseCommandLine, TakesAccelerationsInG) {
  const Outcome outcome = Run(std::string("response ") + kCar + " --frequencies 10Hz --acceleration 0.5g --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const double amplitude = Json::parse(outcome.out)["modes"][0]["post_amplitude_m"][0];
  EXPECT_NEAR(amplitude * std::pow(2 * std::numbers::pi * 10, 2), 0.5 * 9.80665, 1e-12);  // rounding
}

TEST_F(ResponseCommandLine, OfAStudyWritesAFolderToo) {
  const Outcome outcome = Run("response studies/landrover110/model2.yaml -o result");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* file : {"response.csv", "response.svg", "result.json"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / "result" / file)) << file;
}

TEST_F(ResponseCommandLine, DoesNotWriteOverItsInput) {
  const Outcome outcome = Run(std::string("response ") + kCar + " -o urdf");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, ContainsRegex("urdf: error: .* quarter_car.urdf.*\\[folder-holds-input\\]"));
}

TEST_F(ResponseCommandLine, RefusesWordsItDoesNotKnow) {
  for (const char* options : {"--direction sideways", "--engine ful", "--frequencies", "--sweep up"})
    EXPECT_EQ(Run(std::string("response ") + kCar + " " + options).code, 2) << options;
  EXPECT_THAT(Run(std::string("response ") + kCar + " --engine ful").err,
              AllOf(HasSubstr("--engine: error: "), HasSubstr("'full'"), HasSubstr("[value-unknown]")));
  EXPECT_THAT(Run(std::string("response ") + kCar + " --amplitud 3mm").err,
              AllOf(HasSubstr("'--amplitude'"), HasSubstr("[argument-misspelt]")));
  EXPECT_THAT(Run("respons").err, AllOf(HasSubstr("'response'"), HasSubstr("[argument-misspelt]")));
}

}  // namespace
}  // namespace fourpost
