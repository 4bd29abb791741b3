#include "identify/experiments/four_post/four_post_data.h"

#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <utility>

#include <gmock/gmock.h>

#include "analysis/signals/decibel.h"
#include "analysis/text/number.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/four_post/response_misfit.h"
#include "identify/experiments/static_loads/findings.h"
#include "identify/experiments/static_loads/static_load_data.h"
#include "identify/residuals/history_misfit.h"
#include "identify/study/loaded_study.h"
#include "tests/findings.h"
#include "tests/identify/shipped_study.h"
#include "tests/temporary_folder.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/findings.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::four_post_data_test {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

constexpr const char* kRecording =
    "frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean\n"
    "1,0.01,s_left,1,0,0.03,1,0.001\n"
    "1,0.01,s_right,1,90,0.04,1,0.003\n"
    "2,0.01,s_left,2,0,0.03,1,0.001\n"
    "2,0.01,s_right,2,90,0.04,1,0.003\n"
    "1,0.01,F_left,100,0,3,1,5\n"
    "2,0.01,F_left,100,0,3,1,5\n";

/// A study of a vehicle with one post, one strut and one load cell.
class FourPostDataTest : public testing::Test {
 protected:
  FourPostDataTest() {
    vehicle_.tyres = {{.name = "tyre"}};
    vehicle_.posts = {{.name = "left"}, {.name = "right"}};
    vehicle_.sensors = {{.name = "strut", .type = Sensor::Type::kStrut},
                        {.name = "load", .type = Sensor::Type::kLoadCell}};
    plan_.file = "study.yaml";
    plan_.recordings = {
        {.name = "run", .file = folder_.Write("run.csv", kRecording), .posts = {{"left", 0}, {"right", -1}}}};
    plan_.channels = {{"strut", {ChannelSource::Combine::kMean, {"s_left", "s_right"}, 7}}};
    rest_.file = "study.yaml";
    rest_.table = folder_.Write("static.csv", "quantity,unit,value,sd\nl,kN,3,0.003\nr,kN,4,0.004\n");
    rest_.tyres = {{"tyre", {ChannelSource::Combine::kSum, {"l", "r"}, 9}}};
  }

  struct Data {
    std::vector<MeasuredRun> runs;
    std::vector<MeasuredLoad> static_loads;
  };

  Data Read() { return {LoadRuns(plan_, vehicle_, diagnostics_), LoadStaticLoads(rest_, vehicle_, diagnostics_)}; }

  Data Load() {
    Data data = Read();
    EXPECT_EQ(diagnostics_.Format(), "");
    return data;
  }

  Diagnostics Faults() {
    Read();
    EXPECT_TRUE(diagnostics_.HasErrors());
    for (const Diagnostic& item : diagnostics_.items()) EXPECT_EQ(item.place.file, "study.yaml");
    return diagnostics_;
  }

  /// The only one.
  Diagnostics Fault() {
    Faults();
    EXPECT_EQ(diagnostics_.items().size(), 1u) << diagnostics_.Format();
    return diagnostics_;
  }

  TemporaryFolder folder_;
  Vehicle vehicle_;
  FourPostPlan plan_;
  StaticLoadPlan rest_;
  Diagnostics diagnostics_;
};

TEST_F(FourPostDataTest, AveragesPhasorsMeansAndTheirDeviations) {
  const MeasuredChannel channel = Load().runs.at(0).channels.at(0);
  EXPECT_EQ(channel.name, "strut");
  EXPECT_LT(std::abs(channel.response[0] - std::complex<double>(0.5, 0.5)), 1e-15);  // rounding
  EXPECT_THAT(channel.mean, ElementsAre(DoubleEq(0.002), DoubleEq(0.002)));
  // The mean lies 45 degrees from both phasors: each gives half its variance along and half across, and a quarter of
  // that for the mean. Pooled over gains 1 and 2, one degree is worth sqrt(2.5) degrees.
  const double across = std::acos(-1.0) / 180 * std::sqrt(2.5);
  const double expected = std::sqrt((0.03 * 0.03 + 0.04 * 0.04 + 2 * across * across) / 8);
  EXPECT_THAT(channel.radial_sd, ElementsAre(DoubleEq(expected), DoubleEq(expected)));
  EXPECT_THAT(channel.tangential_sd, ElementsAre(DoubleEq(expected), DoubleEq(expected)));
}

TEST_F(FourPostDataTest, TakesDeviationsOfOneRepeatOverTheRootOfTheirNumber) {
  const MeasuredChannel of_mean = Load().runs.at(0).channels.at(0);
  plan_.recordings[0].repeats = 4;
  const MeasuredChannel of_one = Load().runs.at(0).channels.at(0);
  EXPECT_EQ(of_one.response, of_mean.response);
  EXPECT_DOUBLE_EQ(of_one.radial_sd[0], of_mean.radial_sd[0] / 2);
  EXPECT_DOUBLE_EQ(of_one.tangential_sd[1], of_mean.tangential_sd[1] / 2);
}

TEST_F(FourPostDataTest, WarnsOfMembersThatMoveAgainstEachOther) {
  std::string opposite = kRecording;
  for (const char* row : {"s_right,1,90", "s_right,2,90"})
    opposite.replace(opposite.find(row), std::string(row).size(), std::string(row, 10) + "180");
  plan_.recordings[0].file = folder_.Write("opposite.csv", opposite);
  plan_.recordings.push_back(plan_.recordings[0]);
  Read();
  ASSERT_FALSE(diagnostics_.HasErrors());
  EXPECT_THAT(diagnostics_, Reports(kMembersOpposed, 7, {"'s_left'", "'s_right'", "'strut'"}));
  // Of both recordings once.
  EXPECT_EQ(diagnostics_.items().size(), 1u) << diagnostics_.Format();
}

TEST_F(FourPostDataTest, AddsTheDeviationsOfPhasorsInLine) {
  plan_.channels = {{"load", {ChannelSource::Combine::kSum, {"F_left", "F_left"}, 7}}};
  const MeasuredChannel channel = Load().runs.at(0).channels.at(0);
  EXPECT_THAT(channel.radial_sd, ElementsAre(DoubleEq(std::hypot(3, 3)), DoubleEq(std::hypot(3, 3))));
}

TEST_F(FourPostDataTest, RefusesAChannelOfAnotherQuantity) {
  plan_.channels[0].second.channels[1] = "F_left";
  plan_.recordings.push_back(plan_.recordings[0]);
  plan_.recordings.back().name = "again";
  // Of both recordings once.
  EXPECT_THAT(Fault(), Reports(kSineUnitsDiffer, 7, {"'F_left' is in N", "'strut' in m"}));
}

TEST_F(FourPostDataTest, RefusesDifferencesThatNothingWeighs) {
  plan_.recordings[0].file = folder_.Write("run.csv",
                                           "frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n"
                                           "1,0.01,s_left,1,0\n1,0.01,s_right,1,90\n");
  EXPECT_EQ(Load().runs.size(), 1u);
  plan_.model_error.gain_dB = 0;
  EXPECT_THAT(Fault(), Reports(kSineWithoutWeight, 7, {"'strut'"}));
}

TEST_F(FourPostDataTest, NamesAPostThatIsLeftOut) {
  plan_.recordings[0].posts = {{"right", -1}};
  EXPECT_THAT(Fault(), Reports(kPostShareMissing, 0, {"'run'", "'left'"}));
}

TEST_F(FourPostDataTest, PoolsDeviationsOverNeighbouringFrequencies) {
  plan_.channels = {{"strut", {ChannelSource::Combine::kMean, {"s_left"}, 7}}};
  const MeasuredChannel channel = Load().runs.at(0).channels.at(0);
  // One degree of gains 1 and 2.
  const double pooled = std::acos(-1.0) / 180 * std::sqrt((1.0 + 4.0) / 2);
  EXPECT_THAT(channel.tangential_sd, ElementsAre(DoubleEq(pooled), DoubleEq(pooled)));
}

TEST_F(FourPostDataTest, LeavesTheMeanForceToTheStaticLoads) {
  plan_.channels = {{"load", {ChannelSource::Combine::kMean, {"F_left"}, 7}}};
  const MeasuredChannel channel = Load().runs.at(0).channels.at(0);
  EXPECT_EQ(channel.sensor, 1u);
  EXPECT_THAT(channel.mean, testing::IsEmpty());
}

TEST_F(FourPostDataTest, ReadsPostsAndStaticLoads) {
  const Data data = Load();
  EXPECT_THAT(data.runs.at(0).excitation.shape, ElementsAre(0, -1));
  EXPECT_THAT(data.runs.at(0).excitation.frequency_Hz, ElementsAre(1, 2));
  ASSERT_EQ(data.static_loads.size(), 1u);
  EXPECT_DOUBLE_EQ(data.static_loads[0].load_N, 7000);
  EXPECT_DOUBLE_EQ(data.static_loads[0].sd_N, 5);
}

/// Of tyres left and right of each other.
void PutPostsSideBySide(Vehicle& vehicle) {
  vehicle.links = {{.name = "ground"}};
  vehicle.tyres = {{.name = "tyre", .point = {.link = 0, .xyz = {0, 0.7, 0}}},
                   {.name = "tyre_right", .point = {.link = 0, .xyz = {0, -0.7, 0}}}};
  vehicle.posts[0].tyre = 0;
  vehicle.posts[1].tyre = 1;
}

TEST_F(FourPostDataTest, MovesPostsInAPattern) {
  PutPostsSideBySide(vehicle_);
  plan_.recordings[0].posts.clear();
  plan_.recordings[0].pattern = "roll";
  EXPECT_THAT(Load().runs.at(0).excitation.shape, ElementsAre(1, -1));
}

TEST_F(FourPostDataTest, RefusesAPatternThatThePostsCannotMake) {
  PutPostsSideBySide(vehicle_);
  plan_.recordings[0].posts.clear();
  plan_.recordings[0].pattern = "pitch";
  plan_.recordings[0].line = 3;
  EXPECT_THAT(Fault(), Reports(kPatternSides, 3, {"'pitch'", "front", "rear"}));
}

TEST_F(FourPostDataTest, KeepsTheFrequenciesOfABand) {
  const std::vector<MeasuredRun> runs = InBand(Load().runs, 1.5, 2);
  EXPECT_THAT(runs.at(0).excitation.frequency_Hz, ElementsAre(2));
  EXPECT_EQ(runs[0].channels[0].response.size(), 1u);
  EXPECT_EQ(runs[0].channels[0].radial_sd.size(), 1u);
  EXPECT_EQ(runs[0].channels[0].mean.size(), 1u);
}

TEST_F(FourPostDataTest, NamesAnUnknownSensor) {
  plan_.channels[0].first = "struts";
  EXPECT_THAT(Fault(), Reports(kSineSensorUnknown, 7, {"'struts'", "'strut'"}));
}

TEST_F(FourPostDataTest, NamesAnUnknownChannel) {
  plan_.channels[0].second.channels[1] = "s_rigth";
  EXPECT_THAT(Fault(), Reports(kSineChannelMissing, 7, {"run.csv", "'s_rigth'", "'s_right'"}));
}

TEST_F(FourPostDataTest, NamesAnUnknownPost) {
  plan_.recordings[0].posts = {{"left", 0}, {"right", 1}, {"rigth", 1}};
  plan_.recordings[0].line = 3;
  EXPECT_THAT(Fault(), Reports(kSinePostUnknown, 3, {"'rigth'", "'right'"}));
}

TEST_F(FourPostDataTest, NamesAnUnknownTyreAndAnUnknownLoadAtOnce) {
  rest_.tyres = {{"tire", {ChannelSource::Combine::kSum, {"l", "q"}, 9}}};
  const Diagnostics faults = Faults();
  EXPECT_THAT(faults, Reports(kStaticLoadTyreUnknown, 9, {"'tire'"}));
  EXPECT_THAT(faults, Reports(kStaticLoadMissing, 9, {"static.csv", "'q'"}));
}

TEST_F(FourPostDataTest, RefusesAStaticLoadThatIsExact) {
  rest_.table = folder_.Write("static.csv", "quantity,unit,value,sd\nl,kN,3,0\nr,kN,4,0\n");
  EXPECT_THAT(Fault(), Reports(kStaticLoadWithoutDeviation, 9));
}

/// A study of the shipped planar Land Rover with gyros, and of recordings that it makes itself: a twin.
class GyroTwin : public testing::Test {
 protected:
  GyroTwin() {
    const std::string gyros =
        R"(<fp:sensor name="pitch_rate" type="gyro" link="chassis" axis="0 1 0"/>
           <fp:sensor name="nose_up_rate" type="gyro" link="chassis" axis="0 -1 0"/></robot>)";
    const std::filesystem::path source = FOURPOST_SOURCE_DIR;
    std::filesystem::create_directory(folder_.path() / "urdf");
    std::filesystem::create_directory_symlink(source / "meshes", folder_.path() / "meshes");
    const std::string car = ReadText(source / "urdf/landrover110_linkage.urdf");
    const auto file = folder_.Write("urdf/car.urdf", Replace(car, "</robot>", gyros));
    Diagnostics diagnostics;
    vehicle_ = ReadVehicle(file, diagnostics).value();
    run_.excitation = {{0.01, 1, 3, 8}, {0.01, 0.01, 0.005, 0.002}, PostPattern(vehicle_, "pitch")};
    model_ = CondensedVehicle(vehicle_).At(vehicle_.ParameterValues());
  }

  FrequencyResponse Modelled() const { return ModelledResponses(model_, vehicle_.sensors, {run_}).at(0); }

  /// The rates in `unit`, of which a radian a second has `per_rad`.
  std::string Recording(const std::string& unit, double per_rad) const {
    std::string text = "frequency_Hz,post_amplitude_m,channel,unit,gain,phase_deg\n";
    const FrequencyResponse response = Modelled();
    for (const char* name : {"pitch_rate", "nose_up_rate"})
      for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i) {
        const std::complex<double> rate = response.Find(name)->response[i];
        text += FormatNumber(response.frequency_Hz[i]) + "," + FormatNumber(response.amplitude_m[i]) + "," + name +
                "," + unit + "," + FormatNumber(per_rad * std::abs(rate)) + "," +
                FormatNumber(DegreesFromRadians(std::arg(rate))) + "\n";
      }
    return text;
  }

  /// `channels` is a line of the study's.
  std::optional<LoadedStudy> Load(const std::string& recording, const std::string& channels) {
    folder_.Write("pitch.csv", recording);
    const auto study = folder_.Write(
        "study.yaml", "vehicle: urdf/car.urdf\nrecordings:\n  - {file: pitch.csv, posts: pitch}\nchannels:\n  " +
                          channels + "\nband: [0.01 Hz, 10 Hz]\n");
    return LoadStudy(study, diagnostics_);
  }

  TemporaryFolder folder_;
  Vehicle vehicle_;
  MeasuredRun run_;
  CondensedModel model_;
  Diagnostics diagnostics_;
};

TEST_F(GyroTwin, FitsItsOwnRecordingInRadiansAndInDegrees) {
  for (const auto& [unit, per_rad] : {std::pair("rad/s", 1.0), std::pair("deg/s", DegreesFromRadians(1))}) {
    const auto study = Load(Recording(unit, per_rad), "pitch_rate: pitch_rate\n  nose_up_rate: nose_up_rate");
    ASSERT_TRUE(study) << diagnostics_.Format();
    for (const ChannelMisfit& misfit : ResponseMisfits(Sines(*study).runs, {Modelled()})) {
      EXPECT_LT(misfit.rms_dB, 1e-12) << misfit.name;  // rounding
      EXPECT_LT(misfit.rms_deg, 1e-10) << misfit.name;
    }
  }
}

// At a hundredth of a hertz the car follows the posts: nose down positive, it turns by -2 z / wheelbase, a quarter of a
// cycle ahead of that.
TEST_F(GyroTwin, ReadsTheRateOfTurningPerMetreOfThePost) {
  const double wheelbase = 2.794;
  const std::complex<double> slow(0, -2 * std::numbers::pi * 0.01 * 2 / wheelbase);
  const FrequencyResponse response = Modelled();
  // The body's weight above its springs turns it further, by 2 %.
  EXPECT_LT(std::abs(response.Find("pitch_rate")->response[0] / slow - 1.0), 0.03);
  EXPECT_LT(std::abs(response.Find("nose_up_rate")->response[0] / -slow - 1.0), 0.03);
  EXPECT_EQ(response.Find("pitch_rate")->unit, "rad/s");
}

TEST_F(GyroTwin, RefusesAChannelThatIsNoRateOfTurning) {
  EXPECT_FALSE(Load(Recording("mm", 1), "pitch_rate: pitch_rate"));
  EXPECT_THAT(diagnostics_, Reports(kSineUnitsDiffer, 5, {"'pitch_rate' is in m", "'pitch_rate' in rad/s"}));
}

TEST_F(GyroTwin, RefusesARateOfTurningForAnotherSensor) {
  EXPECT_FALSE(Load(Recording("deg/s", 57), "s_strut_front: pitch_rate"));
  EXPECT_THAT(diagnostics_, Reports(kSineUnitsDiffer, 5, {"'pitch_rate' is in rad/s", "'s_strut_front' in m"}));
}

}  // namespace
}  // namespace fourpost::four_post_data_test
