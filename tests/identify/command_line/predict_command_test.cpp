// `fourpost fit` of time histories and `fourpost predict` as a user meets them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/program.h"
#include "tests/identify/recorded_station.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::json;

constexpr const char* kStudy = R"(vehicle: urdf/single_wheel_station.urdf
histories:
  - file: sweep.csv
    posts: {ground: z_ground}
    channels: {z_sprung: z_sprung, z_unsprung: z_unsprung, a_sprung: a_sprung, F_tyre: F_tyre}
    filter: {order: 4, cutoff: 30 Hz}
free: [m_sprung, c_bump, c_rebound]
search: {evaluations: 10, starts: 1}
)";

class PredictCommandLine : public ProgramTest {
 protected:
  PredictCommandLine() {
    temporary_.Write("study.yaml", kStudy);
    temporary_.Write("sweep.csv", Recording(0.01));
    temporary_.Write("other.csv", Recording(0.006));
  }

  /// Of a station that is not as its file says.
  std::string Recording(double amplitude_m) const {
    Vehicle vehicle = ShippedVehicle("single_wheel_station");
    Set(vehicle, "m_sprung", 190);
    Set(vehicle, "c_bump", 800);
    return StationCsv(RecordStation(vehicle, SensorModel::Filter{4, 30}, amplitude_m), vehicle);
  }

  void Fit() const {
    const Outcome outcome = Run("fit study.yaml -o run");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  void ExpectRefused(const std::string& arguments, const std::string& message, int code = 3) const {
    const Outcome outcome = Run("predict " + arguments);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
  }
};

TEST_F(PredictCommandLine, ShowsWhatAFitIsWorthOnARecordingThatItHasNotSeen) {
  Fit();
  const Json fit = Json::parse(ReadText(folder_ / "run/result.json"));
  EXPECT_NEAR(fit["parameters"][0]["value"].get<double>(), 190, 0.01);
  EXPECT_NEAR(fit["parameters"][1]["value"].get<double>(), 800, 0.1);
  ASSERT_EQ(fit["channels"].size(), 4u);
  EXPECT_EQ(fit["channels"][0]["recording"], "sweep");
  EXPECT_EQ(ReadText(folder_ / "run/study.yaml"), kStudy);
  EXPECT_THAT(ReadText(folder_ / "run/history.svg"), StartsWith("<svg"));
  EXPECT_THAT(ReadText(folder_ / "run/history.csv"), HasSubstr("z_sprung_measured,z_sprung_modelled"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run/response.csv"));

  const Outcome told = Run("predict run --recording other.csv -o predicted --json");
  ASSERT_EQ(told.code, 0) << told.err;
  const Json prediction = Json::parse(told.out);
  EXPECT_EQ(Json::parse(ReadText(folder_ / "predicted/result.json")), prediction);
  EXPECT_EQ(prediction["was_fitted"], false);
  EXPECT_THAT(told.err, Not(HasSubstr("[recording-was-fitted]")));
  // Whatever it is called.
  temporary_.Write("sweep_again.csv", ReadText(folder_ / "sweep.csv"));
  const Outcome seen = Run("predict run --recording sweep_again.csv --json");
  EXPECT_EQ(Json::parse(seen.out)["was_fitted"], true);
  EXPECT_THAT(seen.err, HasSubstr("[recording-was-fitted]"));
  ASSERT_EQ(prediction["channels"].size(), 4u);
  for (const Json& channel : prediction["channels"]) {
    EXPECT_EQ(channel["recording"], "other");
    // The integration's error squared.
    EXPECT_LT(channel["nmse_percent"].get<double>(), 1e-2) << channel["name"];
    EXPECT_GT(channel["vaf_percent"].get<double>(), 99.99);
  }
}

TEST_F(PredictCommandLine, WarnsOfATyreThatPulls) {
  Vehicle vehicle = ShippedVehicle("single_wheel_station");
  vehicle.tyres[0].lifts_off = false;
  temporary_.Write("sweep.csv", StationCsv(RecordStation(vehicle, SensorModel::Filter{4, 30}, 0.01, 1.5), vehicle));
  ReplaceIn("urdf/single_wheel_station.urdf", "stiffness=\"$kt\"", "stiffness=\"$kt\" liftoff=\"false\"");
  const std::string warning = "fp:tyre 'tyre' pulls on the ground in [0-9]+ of [0-9]+ samples of 'sweep', down to -";
  const Outcome fit = Run("fit study.yaml -o run");
  EXPECT_THAT(fit.err, ContainsRegex(warning));
  const Json result = Json::parse(ReadText(folder_ / "run/result.json"));
  EXPECT_THAT(result["warnings"].dump(), ContainsRegex(warning));
  const Outcome told = Run("predict run --recording sweep.csv --json");
  EXPECT_THAT(told.err, ContainsRegex(warning));
  EXPECT_THAT(Json::parse(told.out)["warnings"].dump(), ContainsRegex(warning));
  EXPECT_THAT(Run("response study.yaml").err, ContainsRegex(warning));
  // A quiet one.
  temporary_.Write("sweep.csv", Recording(0.01));
  EXPECT_THAT(Run("predict run --recording sweep.csv").err, Not(HasSubstr("pulls on the ground")));
}

TEST_F(PredictCommandLine, TellsOfAChannelThatIsNotSynchronised) {
  Fit();
  TimeHistory history = RecordStation(ShippedVehicle("single_wheel_station"), SensorModel::Filter{4, 30});
  const Eigen::Index kept = history.size() - 20;
  history.readings.col(4).tail(kept) = history.readings.col(4).head(kept).eval();
  temporary_.Write("late.csv", StationCsv(history, ShippedVehicle("single_wheel_station")));
  const Outcome told = Run("predict run --recording late.csv");
  EXPECT_THAT(told.err, ContainsRegex("'F_tyre' of 'late' comes 4.*\\[channel-late-of-"));
  EXPECT_THAT(told.err, Not(HasSubstr("'z_sprung' of 'late' comes")));
  // As a script finds it, and in the results.
  const Outcome json = Run("predict run --recording late.csv --json -o late_results");
  const Json prediction = Json::parse(json.out);
  ASSERT_EQ(prediction["warnings"].size(), 1u);
  const auto warning = prediction["warnings"][0]["text"].get<std::string>();
  EXPECT_THAT(warning, HasSubstr("'F_tyre' of 'late' comes 4"));
  EXPECT_THAT(told.err, HasSubstr(warning.substr(warning.find('\''))));
  EXPECT_EQ(Json::parse(ReadText(folder_ / "late_results/result.json"))["warnings"], prediction["warnings"]);
  EXPECT_EQ(Json::parse(Run("predict run --recording other.csv --json").out)["warnings"], Json::array());
  EXPECT_THAT(Run("predict run --recording other.csv").err, Not(HasSubstr("[channel-late")));
}

/// As recorded, a change of its samples.
class FaultyRecordingCommandLine : public PredictCommandLine {
 protected:
  /// All that a fit of it warns of, id first, which is in its results once each.
  std::vector<std::string> WarningsOf(const TimeHistory& history) const {
    temporary_.Write("sweep.csv", StationCsv(history, vehicle_));
    return Warnings();
  }
  std::vector<std::string> Warnings() const {
    const Outcome outcome = Run("fit --no-suggest study.yaml -o run");
    const Json result = Json::parse(ReadText(folder_ / "run/result.json"));
    const std::string page = ReadText(folder_ / "run/report.html");
    std::vector<std::string> warnings;
    for (const Json& item : result["warnings"]) {
      const auto text = item["text"].get<std::string>();
      const std::string id = "[" + item["id"].get<std::string>() + "]";
      EXPECT_THAT(outcome.err, HasSubstr(text.substr(text.find(": ") + 2) + " " + id));
      // Up to the first sign that HTML writes otherwise.
      EXPECT_THAT(page, HasSubstr(text.substr(0, text.find('\''))));
      EXPECT_EQ(std::count(warnings.begin(), warnings.end(), id + " " + text), 0);
      warnings.push_back(id + " " + text);
    }
    EXPECT_THAT(outcome.out, Not(HasSubstr("[channel-")));
    return warnings;
  }

  static void Delay(Eigen::Ref<Eigen::VectorXd> signal, Eigen::Index samples) {
    const Eigen::Index kept = signal.size() - samples;
    signal.tail(kept) = signal.head(kept).eval();
    signal.head(samples).setConstant(signal[samples]);
  }

  const Vehicle vehicle_ = ShippedVehicle("single_wheel_station");
  TimeHistory history_ = RecordStation(vehicle_, SensorModel::Filter{4, 30});
};

TEST_F(FaultyRecordingCommandLine, AFitSaysNothingOfAGoodOne) { EXPECT_THAT(WarningsOf(history_), IsEmpty()); }

// The fit meets the late channel half-way; the healthy ones are not accused.
TEST_F(FaultyRecordingCommandLine, AFitAccusesTheLateChannelAlone) {
  Delay(history_.readings.col(4), 10);
  EXPECT_THAT(WarningsOf(history_),
              ElementsAre(AllOf(StartsWith("[channel-late-of-others] study.yaml:5: 'F_tyre' of 'sweep' comes 20"),
                                HasSubstr("% with 'F_tyre: {channel: F_tyre, delay: 20"))));
}

// The fit hides it by its parameters; the second derivative does not.
TEST_F(FaultyRecordingCommandLine, AFitTellsOfAHeightThatIsLate) {
  Delay(history_.readings.col(0), 10);
  EXPECT_THAT(
      WarningsOf(history_),
      ElementsAre(AllOf(
          StartsWith("[channel-late-of-point] study.yaml:5: 'z_sprung' of 'sweep' comes 20 ms later than 'a_sprung'"),
          HasSubstr("'z_sprung: {channel: z_sprung, delay: 20 ms}' in the study"))));
}

// The values of the file have not been adapted to it.
TEST_F(FaultyRecordingCommandLine, AFitTellsOfAPostThatIsLate) {
  Delay(history_.posts.col(0), 10);
  ReplaceIn("urdf/single_wheel_station.urdf", "value=\"1010 N*s/m\"", "value=\"900 N*s/m\"");
  ReplaceIn("urdf/single_wheel_station.urdf", "value=\"15.01 kN/m\"", "value=\"16 kN/m\"");
  // To what values of the file that are off by some per cent make of it.
  EXPECT_THAT(WarningsOf(history_),
              ElementsAre(AllOf(StartsWith("[posts-not-synchronised] study.yaml:4: "), HasSubstr(" ms earlier"),
                                ContainsRegex("add 'delay: (19|20|21)"), HasSubstr("channels of its 'posts'"))));
}

TEST_F(FaultyRecordingCommandLine, AFitTellsOfSwappedChannels) {
  ReplaceIn("study.yaml", "z_sprung: z_sprung, z_unsprung: z_unsprung", "z_sprung: z_unsprung, z_unsprung: z_sprung");
  EXPECT_THAT(Warnings(),
              ElementsAre(AllOf(StartsWith("[history-channels-swapped"), HasSubstr(": 'z_sprung' of 'sweep'")),
                          AllOf(StartsWith("[history-channels-swapped"), HasSubstr(": 'z_unsprung' of 'sweep'"))));
}

TEST_F(FaultyRecordingCommandLine, AFitTellsOfAWrongSign) {
  history_.readings.col(4) *= -1;
  EXPECT_THAT(WarningsOf(history_),
              Contains(AllOf(StartsWith("[channel-inverted] study.yaml:5: 'F_tyre' of 'sweep' "),
                             HasSubstr("% with 'F_tyre: {channel: F_tyre, sign: -1}' in the study"))));
}

TEST_F(FaultyRecordingCommandLine, AFitTellsOfAWrongUnit) {
  history_.readings.col(2) /= 9.80665;
  EXPECT_THAT(WarningsOf(history_),
              Contains(AllOf(StartsWith("[channel-unit-mistaken] study.yaml:5: 'a_sprung' of 'sweep' "),
                             HasSubstr(" in g instead of m/s^2"),
                             HasSubstr("% with 'a_sprung: {channel: a_sprung, unit: g}' in the study"))));
}

TEST_F(PredictCommandLine, AFitComparesItsValuesWithTheFiles) {
  Fit();
  const std::string table = ReadText(folder_ / "run/parameters.csv");
  EXPECT_THAT(table, StartsWith("parameter,unit,start,fitted,difference_percent,sd,lower_95,upper_95"));
  EXPECT_THAT(table, HasSubstr("\nm_sprung,kg,"));
}

TEST_F(PredictCommandLine, TheCompromiseCostTellsNoDeviations) {
  temporary_.Write("study.yaml", std::string(kStudy) + "cost: compromise\n");
  const Outcome outcome = Run("fit --no-suggest study.yaml -o run");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("[compromise-without-deviations]"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("times what noise")));
  const Json result = Json::parse(ReadText(folder_ / "run/result.json"));
  for (const Json& parameter : result["parameters"]) EXPECT_TRUE(parameter["sd"].is_null());
  EXPECT_THAT(ReadText(folder_ / "run/report.html"), Not(HasSubstr("the data do not tell")));
}

TEST_F(PredictCommandLine, RefusesErrorsWithoutADeviation) {
  temporary_.Write("study.yaml", std::string(kStudy) + "model_error: {history: 0 %}\n");
  const Outcome outcome = Run("fit --no-suggest study.yaml -o run");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("study.yaml:3: error: 'z_sprung' of history 'sweep' has no 'noise' and no "
                                     "'model_error', so its residuals cannot be weighted"));
}

TEST_F(PredictCommandLine, ConfirmsAFitByTheMultibodySystem) {
  Fit();
  const Outcome told = Run("predict run --recording sweep.csv --engine full --json");
  ASSERT_EQ(told.code, 0) << told.err;
  const Json answer = Json::parse(told.out);
  EXPECT_EQ(answer["engine"], "full");
  EXPECT_LE(answer["integration"]["change_by_last_halving"].get<double>(), 1e-3);
  for (const Json& channel : answer["channels"])
    // Both fit to the integration's error squared.
    EXPECT_NEAR(channel["reduced_nmse_percent"].get<double>(), channel["nmse_percent"].get<double>(), 2e-3);
  EXPECT_THAT(Run("predict run --recording sweep.csv --engine full").out, HasSubstr("of reduced model"));
}

// The quarter car's wheel moves straight: there is nothing that linear kinematics leave out.
TEST_F(PredictCommandLine, ChecksLinearKinematics) {
  Fit();
  const Outcome told = Run("predict run --recording sweep.csv --json");
  ASSERT_EQ(told.code, 0) << told.err;
  const Json answer = Json::parse(told.out);
  EXPECT_EQ(answer["engine"], "reduced");
  EXPECT_LT(answer["linear_kinematics_error"]["value"].get<double>(), 1e-5);
  EXPECT_FALSE(answer["channels"][0].contains("reduced_nmse_percent"));
  EXPECT_THAT(Run("predict run --recording sweep.csv").out,
              HasSubstr("below the visible limit (0.6 %): reduced model used"));
  // By its older name too.
  const Outcome reduced = Run("predict run --recording sweep.csv --engine condensed --json");
  EXPECT_TRUE(Json::parse(reduced.out)["linear_kinematics_error"].is_null());
}

TEST_F(PredictCommandLine, TakesTheKalmanFiltersNoiseFromElsewhere) {
  Fit();
  ExpectRefused("run --recording other.csv --kalman", "name the recording it was fitted to by --noise-from");
  const Outcome simulated = Run("predict run --recording other.csv --json");
  const Outcome outcome = Run("predict run --recording other.csv --kalman --noise-from sweep.csv --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json channels = Json::parse(outcome.out)["channels"];
  for (std::size_t i = 0; i < channels.size(); ++i) {
    // The simulation is the same with the filter beside it.
    EXPECT_EQ(channels[i]["nmse_percent"], Json::parse(simulated.out)["channels"][i]["nmse_percent"]);
    EXPECT_TRUE(channels[i]["one_step_nmse_percent"].is_number());
    EXPECT_TRUE(channels[i]["innovations_beyond"].is_number());
  }
}

TEST_F(PredictCommandLine, AFitByPredictionKeepsItsNoise) {
  std::string study = kStudy;
  study.replace(study.find("    filter: {order: 4, cutoff: 30 Hz}\n"), 38, "    process: 0.5 m/s^2\n");
  temporary_.Write("study.yaml", study + "cost: prediction\n");
  const Outcome fit = Run("fit study.yaml -o run");
  ASSERT_EQ(fit.code, 0) << fit.err;
  const Json result = Json::parse(ReadText(folder_ / "run/result.json"));
  EXPECT_EQ(result["kalman_noise"][0]["process_sd"][0], 0.5);
  EXPECT_EQ(Run("predict run --recording other.csv --kalman").code, 0);
}

TEST_F(PredictCommandLine, RefusesWhatIsNoFitOrNoRecording) {
  ExpectRefused("urdf --recording other.csv", "[run-without-result]");
  Fit();
  ExpectRefused("run --recording none.csv", "none.csv");
  ExpectRefused("run --recording study.yaml", "[file-of-other-kind]");
  ExpectRefused("run", "[usage]", 2);
  temporary_.Write("odd.csv", "x,z\n1,2\n");
  ExpectRefused("run --recording odd.csv", "[recording-of-other-kind]");
  ExpectRefused("run --recording studies/landrover110/bounce_frf.csv", "(time histories, with a column of times");
  temporary_.Write("less.csv", "time,z_ground\ns,m\n0,0\n1,0\n2,0\n3,0\n");
  ExpectRefused("run --recording less.csv", "[fitted-channels-missing]");
}

TEST_F(PredictCommandLine, SaysThatARecordingOverTimeTellsItsMotionItself) {
  Fit();
  const Outcome told = Run("predict run --recording other.csv --mode heave");
  EXPECT_EQ(told.code, 0);
  EXPECT_THAT(told.err, HasSubstr("[mode-of-history]"));
  EXPECT_EQ(told.out, Run("predict run --recording other.csv").out);
}

TEST_F(PredictCommandLine, TellsOfAChannelInAnotherUnit) {
  Fit();
  std::string text = ReadText(folder_ / "other.csv");
  const std::string units = "m/s^2";
  const std::size_t unit = text.find(units);
  ASSERT_NE(unit, std::string::npos);
  // A thousandth of what it should be.
  temporary_.Write("other.csv", text.replace(unit, units.size(), "mm/s^2"));
  const Outcome outcome = Run("predict run --recording other.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err,
              ContainsRegex("'a_sprung' of 'other' and the model differ by a factor of 1.*\\[channel-unit-"));
}

// Loads at rest beside recordings over time, and no frequency response.
TEST_F(PredictCommandLine, AFitTakesStaticLoadsBesideHistories) {
  temporary_.Write("static.csv", "quantity,unit,value,sd\nload,N,2040,20\n");
  temporary_.Write("study.yaml", std::string(kStudy) + "static_loads: {file: static.csv, tyres: {tyre: load}}\n");
  const Outcome outcome = Run("fit study.yaml -o run");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("static load"));
}

class PredictResponsesCommandLine : public ProgramTest {
 protected:
  void Fit() const {
    ReplaceIn("studies/landrover110/model1.yaml", "  - name: pitch\n    file: pitch_frf.csv\n    posts: pitch\n", "");
    const Outcome outcome = Run("fit --no-suggest studies/landrover110/model1.yaml -o run");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  double PeakOf(const std::string& channel, const std::string& file) const;
};

/// Frequency of the largest modelled gain below the wheels' hop [Hz].
double PredictResponsesCommandLine::PeakOf(const std::string& channel, const std::string& file) const {
  std::istringstream lines(ReadText(folder_ / file));
  double largest = 0;
  double peak_Hz = 0;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells(1);
    for (const char c : line) c == ',' ? static_cast<void>(cells.emplace_back()) : cells.back().push_back(c);
    if (cells[1] != channel || std::stod(cells[3]) > 4 || std::stod(cells[7]) < largest) continue;
    largest = std::stod(cells[7]);
    peak_Hz = std::stod(cells[3]);
  }
  return peak_Hz;
}

TEST_F(PredictResponsesCommandLine, ShowsWhatAFitIsWorthOnAPatternThatItHasNotSeen) {
  Fit();
  const Outcome outcome = Run("predict run --recording studies/landrover110/pitch_frf.csv --json -o prediction");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("posts: pitch, which fits best"));
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["posts"], "pitch");
  EXPECT_EQ(json["channels"].size(), 11u);
  for (const auto& channel : json["channels"]) {
    EXPECT_TRUE(channel["rms_dB"].is_number());
    EXPECT_TRUE(channel["rms_deg"].is_number());
    EXPECT_NEAR(channel["nmse_percent"].get<double>() + channel["vaf_percent"].get<double>(), 100, 1e-9);
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "prediction/response.svg"));
  // Told, the pattern is not guessed.
  const Outcome told = Run("predict run --recording studies/landrover110/pitch_frf.csv --mode pitch --json");
  EXPECT_EQ(told.out, outcome.out);
  EXPECT_EQ(told.err, "");
}

/// `text` without the lines that hold `what`.
std::string WithoutLinesOf(const std::string& text, const std::string& what) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (line.find(what) == std::string::npos) kept += line + '\n';
  return kept;
}

/// The phase of each line of a channel half a turn off.
std::string Turned(const std::string& text, const std::string& channel) {
  std::istringstream lines(text);
  std::string turned;
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t at = line.find("," + channel + ","); at != std::string::npos) {
      // frequency, amplitude, channel, gain, phase
      const std::size_t phase = line.find(',', at + channel.size() + 2) + 1;
      const std::size_t end = line.find(',', phase);
      line.replace(phase, end - phase, std::to_string(std::stod(line.substr(phase)) + 180));
    }
    turned += line + '\n';
  }
  return turned;
}

TEST_F(PredictResponsesCommandLine, TellsOfAWrongPatternAndOfAWrongSign) {
  Fit();
  const Outcome wrong = Run("predict run --recording studies/landrover110/pitch_frf.csv --mode heave");
  EXPECT_EQ(wrong.code, 0);
  EXPECT_THAT(wrong.err,
              AllOf(HasSubstr("'pitch_frf' move as heave (front 1, rear 1)"), HasSubstr("[posts-move-otherwise]")));
  EXPECT_THAT(wrong.err, HasSubstr("look like pitch (front 1, rear -1)"));
  temporary_.Write("turned.csv", Turned(ReadText(folder_ / "studies/landrover110/pitch_frf.csv"), "a_tow_point"));
  const Outcome turned = Run("predict run --recording turned.csv --mode pitch");
  EXPECT_EQ(turned.code, 0);
  EXPECT_THAT(turned.err, ContainsRegex("'a_tow_point' .*\\[sign-opposite\\]"));
  EXPECT_THAT(turned.err, Not(HasSubstr("[posts-move-otherwise]")));
  const Outcome seen = Run("predict run --recording studies/landrover110/bounce_frf.csv --mode heave --json");
  EXPECT_THAT(seen.err, HasSubstr("[recording-was-fitted]"));
  EXPECT_EQ(Json::parse(seen.out)["was_fitted"], true);
}

TEST_F(PredictResponsesCommandLine, LeavesOutWhatWasNotMeasured) {
  Fit();
  const std::string whole = ReadText(folder_ / "studies/landrover110/pitch_frf.csv");
  temporary_.Write("less.csv", WithoutLinesOf(whole, "a_body_FL"));
  const Outcome outcome = Run("predict run --recording less.csv --mode pitch --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, ContainsRegex("less.csv: warning: .* a_body_front.*\\[sensors-not-measured\\]"));
  EXPECT_EQ(Json::parse(outcome.out)["channels"].size(), 10u);
  temporary_.Write("none.csv", "frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n1,0.01,a_other,1,0\n");
  const Outcome none = Run("predict run --recording none.csv");
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, ContainsRegex("none.csv: error: .*\\[fitted-channels-missing\\]"));
}

TEST_F(PredictResponsesCommandLine, APatternThatAPlanarCarCannotMakeIsNotGuessed) {
  Fit();
  const Outcome outcome = Run("predict run --recording studies/landrover110/roll_frf.csv");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no pattern that the posts of landrover110_model1 can make"));
}

TEST_F(PredictResponsesCommandLine, TakesALoad) {
  Fit();
  const std::string predict = "predict run --recording studies/landrover110/bounce_frf.csv --mode heave";
  const Outcome empty = Run(predict);
  const Outcome loaded = Run(predict + " --add-mass '250 kg' --at -2.5,0,0.9");
  EXPECT_EQ(loaded.code, 0) << loaded.err;
  EXPECT_NE(loaded.out, empty.out);
  // At the bounce frequency of the loaded car, sqrt(m / (m + 250 kg)) of the empty one's, its body moves more.
  const Json at_rest = Json::parse(Run(predict + " --json -o empty").out);
  const Json heavier = Json::parse(Run(predict + " --add-mass '250 kg' --at -1.4,0,0.9 --json -o heavy").out);
  EXPECT_EQ(at_rest["channels"].size(), heavier["channels"].size());
  EXPECT_NEAR(PeakOf("a_cg", "heavy/response.csv") / PeakOf("a_cg", "empty/response.csv"), std::sqrt(1803.0 / 2053),
              0.03);  // the grid's spacing
}

TEST_F(PredictResponsesCommandLine, TellsWhatTheLoadDoesToThePosts) {
  Fit();
  const std::string predict =
      "predict run --recording studies/landrover110/bounce_frf.csv --mode heave --add-mass '250 kg' --at ";
  const Json load = Json::parse(Run(predict + "'-1397 mm, 0,90 cm' --json").out)["added_load"];
  EXPECT_EQ(load["mass_kg"], 250);
  EXPECT_EQ(load["place_m"], Json({-1.397, 0, 0.9}));
  EXPECT_EQ(load["body"], "chassis");
  ASSERT_EQ(load["static_loads"].size(), 2U);
  // In the middle of the wheelbase, 2.794 m.
  for (const Json& post : load["static_loads"])
    EXPECT_NEAR(post["with_N"].get<double>() - post["without_N"].get<double>(), 125 * kGravity, 1e-6);  // rounding
  const Outcome told = Run(predict + "-1.397,0,0.9");
  EXPECT_THAT(told.out, testing::StartsWith("added: 250 kg at -1.4, 0, 0.9 m (x, y, z) on 'chassis'\n"
                                            "load at rest  without, N  with, N\nfront "));
  EXPECT_THAT(told.err, Not(HasSubstr("--at")));
  // Beside the plane of a car that has no sides.
  EXPECT_THAT(Run(predict + "-1.397,0.4,0.9").err,
              AllOf(HasSubstr("--at: warning: "), HasSubstr("landrover110_model1"), HasSubstr(" 0.4 m "),
                    HasSubstr(" 0 m: "), HasSubstr("[load-without-roll]")));
}

TEST_F(PredictResponsesCommandLine, RefusesLoadsThatCannotBe) {
  Fit();
  const auto expect = [this](const std::string& load, const std::string& message) {
    const Outcome outcome =
        Run("predict run --recording studies/landrover110/bounce_frf.csv --mode heave --add-mass " + load);
    EXPECT_EQ(outcome.code, 2) << load;
    EXPECT_THAT(outcome.err, HasSubstr(message));
  };
  expect("'250 N' --at -2.5,0", "--add-mass: error: '250 N' is not a mass");
  for (const char* place : {"-2.5,0", "-2.5,0,0.9,1", "'-2.5 kg,0,0.9'", "-2.5,,0.9"})
    expect(std::string("'250 kg' --at ") + place, "[load-place-unreadable]");
  expect("'250 kg' --at -1200,0,900", "[load-far-outside]");
  expect("'250 kg' --at -1200,0,900", "--at: error: -1200, 0, 900 m ");
  expect("'250 kg' --at -1200,0,900", " x from -3.62 to ");
  expect("'20 t' --at 1,0,0.9", "[load-tips-car]");
  expect("'20 t' --at 1,0,0.9", ": rear -");
}

TEST_F(PredictResponsesCommandLine, TellsThatAResultIsNoRecordingAndWhatHasNoUse) {
  Fit();
  const Outcome result = Run("predict run --recording run/response.csv");
  EXPECT_EQ(result.code, 3);
  EXPECT_THAT(result.err, ContainsRegex("response.csv:1: error: .*\\[comparison-as-recording\\]"));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
  const Outcome outcome = Run("predict run --recording studies/landrover110/pitch_frf.csv --kalman");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is a frequency response"));
}

}  // namespace
}  // namespace fourpost
