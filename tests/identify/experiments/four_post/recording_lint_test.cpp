#include "identify/experiments/four_post/recording_lint.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/static_loads/findings.h"
#include "identify/study/findings.h"
#include "identify/study_file/channel_warnings.h"
#include "tests/findings.h"
#include "tests/identify/shipped_study.h"
#include "vehicles/description/gravity.h"

namespace fourpost::recording_lint_test {
namespace {

using testing::ContainsRegex;
using testing::Not;

Diagnostics Lint(const LoadedStudy& study) {
  Diagnostics diagnostics;
  CheckRecordings(study, Severity::kWarning, diagnostics);
  EXPECT_FALSE(diagnostics.HasErrors());
  return diagnostics;
}

/// In the study.
int LineOf(const LoadedStudy& study, const std::string& channel) {
  for (const auto& [name, source] : Sines(study).plan.channels)
    if (name == channel) return source.line;
  throw std::invalid_argument("no channel " + channel);
}

Sensor& SensorOf(LoadedStudy& study, const std::string& name) {
  for (Sensor& sensor : study.vehicle.sensors)
    if (sensor.name == name) return sensor;
  throw std::invalid_argument("no sensor " + name);
}

/// Every response of a channel, changed by its run and place there.
template <typename Change>
void ChangeChannel(LoadedStudy& study, const std::string& name, const Change& change) {
  for (MeasuredRun& run : Sines(study).runs)
    for (MeasuredChannel& channel : run.channels)
      for (std::size_t i = 0; channel.name == name && i < channel.response.size(); ++i)
        change(run, i, channel.response[i]);
}

void Scale(LoadedStudy& study, const std::string& name, double factor) {
  ChangeChannel(study, name, [&](const auto&, std::size_t, std::complex<double>& value) { value *= factor; });
}

class EveryStudy : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(RecordingLint, EveryStudy, testing::Values("model1", "model2", "model3", "full"));

// Of the rig as it was: flexible mounts, sensors a few per cent off, a car that no model is.
TEST_P(EveryStudy, HasNothingToTell) { EXPECT_EQ(Lint(ShippedStudy(GetParam())).Format(), ""); }

TEST_P(EveryStudy, TellsOfAStationOffByAMetre) {
  for (const double metres : {1.0, -1.0}) {
    LoadedStudy study = ShippedStudy(GetParam());
    // As if the sensor had sat a metre from where the file has it.
    SensorOf(study, "a_cross_member").point.xyz.x() -= metres;
    const std::string direction = metres > 0 ? "forward" : "back";
    const Diagnostics found = Lint(study);
    EXPECT_THAT(found, Reports(kStationAlong, LineOf(study, "a_cross_member"), {"'a_cross_member'", direction}));
    EXPECT_THAT(found.Format(), ContainsRegex(" (0.9[0-9]?|1|1.1) m ")) << metres;
  }
}

TEST_P(EveryStudy, TellsOfATurnedAccelerometer) {
  LoadedStudy study = ShippedStudy(GetParam());
  Scale(study, "a_cross_member", -1);
  EXPECT_THAT(Lint(study), Reports(kStationSign, LineOf(study, "a_cross_member"), {"'a_cross_member: ", "sign: -1}"}));
}

/// Every eighth frequency: a sign that few data show, all show, and the audit takes an eighth of its time.
void TakeEveryEighth(LoadedStudy& study) {
  const auto thin = [](auto& values) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); i += 8) values[kept++] = values[i];
    values.resize(kept);
  };
  for (MeasuredRun& run : Sines(study).runs) {
    thin(run.excitation.frequency_Hz);
    thin(run.excitation.amplitude_m);
    for (MeasuredChannel& channel : run.channels) {
      thin(channel.response);
      thin(channel.radial_sd);
      thin(channel.tangential_sd);
      thin(channel.mean);
      thin(channel.mean_sd);
      thin(channel.second_harmonic);
    }
  }
}

TEST_P(EveryStudy, TellsOfAnyChannelOfOppositeSign) {
  LoadedStudy shipped = ShippedStudy(GetParam());
  TakeEveryEighth(shipped);
  for (const MeasuredChannel& channel : Sines(shipped).runs.front().channels) {
    LoadedStudy study = shipped;
    Scale(study, channel.name, -1);
    EXPECT_THAT(Lint(study),
                Reports(kSignOpposite, LineOf(study, channel.name), {"'" + channel.name + "'", "sign: -1"}));
  }
}

/// Of one without loads, whose recordings have no forces any more.
LoadedStudy WithoutForces(const std::string& name) {
  LoadedStudy study = ShippedStudy(name);
  Rest(study).loads.clear();
  for (MeasuredRun& run : Sines(study).runs)
    std::erase_if(run.channels, [](const MeasuredChannel& channel) { return channel.unit == "N"; });
  return study;
}

TEST(RecordingLint, TellsWhatSetsTheScaleWithoutForces) {
  LoadedStudy study = WithoutForces("full");
  EXPECT_THAT(Lint(study), Reports(kScaleNotMeasured, study.study.free_line));
  // A mass that was weighed sets it as well.
  for (const std::size_t index : study.free) {
    Parameter& parameter = study.vehicle.parameters[index];
    if (parameter.dimension == kMass) parameter.prior_sd = 1;
  }
  EXPECT_EQ(Lint(study).Format(), "");
}

// A mass that turns nothing and moves nothing sets no scale.
TEST(RecordingLint, NamesOnlyWhatSetsTheScale) {
  LoadedStudy study = WithoutForces("model2");
  const auto hold = [&](const std::string& name) {
    std::erase_if(study.free, [&](std::size_t i) { return study.vehicle.parameters[i].name == name; });
  };
  hold("m_sprung");
  Parameter idle = study.vehicle.parameters[0];
  idle.name = "m_idle";
  study.vehicle.parameters.push_back(idle);
  const Diagnostics found = Lint(study);
  EXPECT_THAT(found,
              Reports(kScaleNotMeasured, study.study.free_line, {"(m_sprung)", "as its range or 'prior_sd' says"}));
  EXPECT_THAT(found, Not(Reports(kScaleNotMeasured, study.study.free_line, {"m_idle"})));
  // Without a range it counts as exact.
  for (Parameter& parameter : study.vehicle.parameters)
    if (parameter.name == "m_sprung") parameter.lower = parameter.upper = parameter.value;
  EXPECT_THAT(Lint(study), Reports(kScaleNotMeasured, study.study.free_line, {"which no standard deviation includes"}));
}

TEST(RecordingLint, TellsOfAScaleThatIsOff) {
  LoadedStudy study = ShippedStudy("model1");
  Scale(study, "a_cross_member", 9.80665);
  EXPECT_THAT(Lint(study), Reports(kStationScale, LineOf(study, "a_cross_member"), {"'a_cross_member'", "9.8 times"}));
}

/// Inertia of this mass between load cell and tyre, in a car whose channel stands for two tyres.
void AddWheelpan(LoadedStudy& study, const std::string& name, double kg, std::size_t post) {
  ChangeChannel(study, name, [&](const MeasuredRun& run, std::size_t i, std::complex<double>& value) {
    value -= kg * std::pow(2 * std::numbers::pi * run.excitation.frequency_Hz[i], 2) * run.excitation.shape[post];
  });
}

TEST(RecordingLint, TellsOfAForgottenWheelpan) {
  LoadedStudy study = ShippedStudy("model1");
  AddWheelpan(study, "F_tyre_rear", 50, 1);
  EXPECT_THAT(Lint(study), Reports(kWheelpanForgotten, LineOf(study, "F_tyre_rear")));
  EXPECT_THAT(Lint(study).Format(), ContainsRegex("'F_tyre_rear' about (4[5-9]|5[0-5])(\\.[0-9]+)? kg"));
  LoadedStudy full = ShippedStudy("full");
  AddWheelpan(full, "F_tyre_FL", 25, 0);
  EXPECT_THAT(Lint(full), Reports(kWheelpanForgotten, LineOf(full, "F_tyre_FL")));
  EXPECT_THAT(Lint(full).Format(), ContainsRegex("'F_tyre_FL' about 2[2-8](\\.[0-9]+)? kg"));
}

// One warning for all, with the mass, where it is written, and the sensors that have it.
TEST_P(EveryStudy, TellsOfWheelpansForgottenOnAllPosts) {
  LoadedStudy study = ShippedStudy(GetParam());
  const bool is_planar = study.vehicle.posts.size() == 2;
  for (std::size_t p = 0; p < study.vehicle.posts.size(); ++p)
    for (const Sensor& sensor : study.vehicle.sensors)
      if (sensor.tyre == study.vehicle.posts[p].tyre && sensor.name.starts_with("F_tyre"))
        AddWheelpan(study, sensor.name, is_planar ? 50 : 25, p);
  const Diagnostics found = Lint(study);
  ASSERT_EQ(found.items().size(), 1u) << found.Format();
  EXPECT_THAT(found, Reports(kWheelpanForgotten, found.items()[0].place.line,
                             {is_planar ? "(F_pan_front, F_pan_rear)" : "(F_pan_FL, F_pan_FR, F_pan_RL, F_pan_RR)"}));
  EXPECT_THAT(found.Format(), ContainsRegex(is_planar ? "wheelpan=\"(4[7-9]|5[0-2])(\\.[0-9]+)? kg\""
                                                      : "wheelpan=\"2[3-6](\\.[0-9]+)? kg\""));
}

// The model at the values of the file says that there is one, the channels say how heavy it is.
TEST(RecordingLint, WeighsAForgottenWheelpanWhateverTheFilesMassesAndRatesAre) {
  LoadedStudy study = ShippedStudy("model1");
  AddWheelpan(study, "F_tyre_rear", 50, 1);
  for (Parameter& parameter : study.vehicle.parameters) parameter.value = 0.5 * (parameter.value + parameter.upper);
  // As with the values of the file.
  EXPECT_THAT(Lint(study).Format(), ContainsRegex("'F_tyre_rear' about (4[5-9]|5[0-5])(\\.[0-9]+)? kg"));
}

TEST(RecordingLint, TellsOfAWheelpanTakenOutTwice) {
  LoadedStudy study = ShippedStudy("model1");
  AddWheelpan(study, "F_tyre_rear", -50, 1);
  EXPECT_THAT(Lint(study), Reports(kWheelpanTakenOut, LineOf(study, "F_tyre_rear")));
  EXPECT_THAT(Lint(study).Format(), ContainsRegex("'F_tyre_rear' about (4[5-9]|5[0-5])(\\.[0-9]+)? kg"));
}

// As friction or another tyre leave over.
TEST(RecordingLint, SaysNothingOfFewKilogramsWithoutAWheelpan) {
  LoadedStudy study = ShippedStudy("model1");
  AddWheelpan(study, "F_tyre_rear", -7, 1);
  EXPECT_THAT(Lint(study), Not(Reports(kWheelpanTakenOut, LineOf(study, "F_tyre_rear"))));
}

TEST(RecordingLint, TellsOfLoadsThatNoMassesMake) {
  LoadedStudy study = ShippedStudy("model1");
  // Bounds leave it some 600 kg.
  for (MeasuredLoad& load : Rest(study).loads) load.load_N += 400 * kGravity;
  EXPECT_THAT(Lint(study), Reports(kStaticLoadsAboveBounds, 0, {"29 kN"}));
  EXPECT_THAT(Lint(study).items().at(0).place.file, testing::EndsWith("static.csv"));
  study = ShippedStudy("model1");
  for (MeasuredLoad& load : Rest(study).loads) load.load_N *= 0.5;
  EXPECT_THAT(Lint(study), Reports(kStaticLoadsBelowBounds, 0));
}

TEST(ChannelWarnings, TellsHowAStudyTurnsAChannelRound) {
  ChannelSource turned{.channels = {"a"}};
  turned.channels[0].factor = -1;
  ChannelSource late{.channels = {"a"}};
  late.channels[0].delay_s = 0.01;
  const ChannelWarnings::Channels channels = {{"x", {.channels = {"a"}}},
                                              {"f", {.combine = ChannelSource::Combine::kSum, .channels = {"a", "b"}}},
                                              {"turned", turned},
                                              {"late", late}};
  Diagnostics diagnostics;
  const ChannelWarnings warnings("study.yaml", channels, diagnostics);
  EXPECT_EQ(warnings.Turned("x"), "x: {channel: a, sign: -1}");
  EXPECT_EQ(warnings.Turned("f"), "f: {sum: [{channel: a, sign: -1}, {channel: b, sign: -1}]}");
  EXPECT_EQ(warnings.Turned("turned"), "turned: a");
  EXPECT_EQ(warnings.Turned("late"), "late: {channel: a, sign: -1, delay: 10 ms}");
}

}  // namespace
}  // namespace fourpost::recording_lint_test
