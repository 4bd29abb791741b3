// A file of settings: what it says, and every fault with its line.
#include "identify/choice/settings_file.h"

#include <string>

#include <gmock/gmock.h>

#include "identify/choice/findings.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::settings_file_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

const std::vector<Metric>& StandIns() {
  static const std::vector<Metric> metrics = {
      {.name = "comfort", .dimension = kAcceleration, .unit = "m/s^2"},
      {.name = "grip", .dimension = kDimensionless, .unit = "%"},
      {.name = "travel", .dimension = kLength, .unit = "mm"},
      {.name = "least_load", .dimension = kForce, .unit = "N", .is_cost = false}};
  return metrics;
}

constexpr const char* kClicks = "click,bump,rebound\n,N*s/m,kN*s/m\n1,500,1\n3,700,2\n5,900,4\n";

class SettingsFileTest : public testing::Test {
 protected:
  SettingsFileTest() { folder_.Write("clicks.csv", kClicks); }

  std::optional<SettingsFile> Read(const std::string& text) {
    diagnostics_ = {};
    return ReadSettingsText(text, folder_.path() / "settings.yaml", vehicle_, StandIns(), diagnostics_);
  }

  SettingsFile Good(const std::string& text) {
    const std::optional<SettingsFile> settings = Read(text);
    EXPECT_TRUE(settings) << diagnostics_.Format();
    return settings.value_or(SettingsFile());
  }

  const Diagnostics& Faults(const std::string& text) {
    EXPECT_FALSE(Read(text));
    return diagnostics_;
  }

  std::size_t IndexOf(const std::string& name) const {
    for (std::size_t i = 0; i < vehicle_.parameters.size(); ++i)
      if (vehicle_.parameters[i].name == name) return i;
    ADD_FAILURE() << name;
    return 0;
  }

  TemporaryFolder folder_;
  Vehicle vehicle_ = ShippedVehicle("quarter_car");
  Diagnostics diagnostics_;
};

TEST_F(SettingsFileTest, HasDefaultsForAllButKnobs) {
  const SettingsFile settings = Good("knobs:\n  spring: {sets: k, values: [10 kN/m, 15 kN/m]}\n");
  ASSERT_EQ(settings.knobs.size(), 1U);
  EXPECT_EQ(settings.knobs[0].change, Knob::Change::kAbsolute);
  EXPECT_FALSE(settings.knobs[0].now);
  EXPECT_EQ(settings.roads.size(), 2U);
  ASSERT_EQ(settings.objectives.size(), 2U);
  EXPECT_EQ(settings.objectives[0].weight, 0.5);
  EXPECT_TRUE(settings.limits.empty());
  EXPECT_EQ(settings.draws, 100U);
}

TEST_F(SettingsFileTest, TakesClicksOfATable) {
  const SettingsFile settings = Good(
      "knobs:\n  damper:\n    sets: {c_bump: bump, c_rebound: 2*rebound}\n    table: clicks.csv\n"
      "    positions: {from: 1, to: 5}\n    now: 3\n");
  const Knob& knob = settings.knobs[0];
  ASSERT_EQ(knob.positions.size(), 5U);
  EXPECT_EQ(knob.positions[1].name, "2");
  // Between rows 1 and 3.
  EXPECT_THAT(knob.positions[1].values, ElementsAre(600, 3000));
  EXPECT_EQ(knob.change, Knob::Change::kRatio);
  EXPECT_EQ(knob.now, 2U);
  // The fitted rates times what the table says against the present click.
  const std::vector<double> values = ValuesAt(settings.knobs, {4}, vehicle_.ParameterValues());
  EXPECT_THAT(values[IndexOf("c_bump")], DoubleNear(1500.0 * 900 / 700, 1e-9));
  EXPECT_THAT(values[IndexOf("c_rebound")], DoubleNear(1500.0 * 2, 1e-9));
  EXPECT_EQ(ValuesAt(settings.knobs, {2}, vehicle_.ParameterValues()), vehicle_.ParameterValues());
}

TEST_F(SettingsFileTest, ChangesByDifferenceAndByRange) {
  const SettingsFile settings = Good(
      "knobs:\n  spring: {sets: {k: 0.5}, range: {from: 10 kN/m, to: 11 kN/m, step: 0.2 kN/m}, now: 10.4 kN/m, change: "
      "difference}\n");
  const Knob& knob = settings.knobs[0];
  ASSERT_EQ(knob.positions.size(), 6U);
  EXPECT_EQ(knob.positions[3].name, "10.6 kN/m");
  const double k = ValuesAt(settings.knobs, {5}, vehicle_.ParameterValues())[IndexOf("k")];
  EXPECT_NEAR(k, 15000 + 0.5 * 600, 1e-9);
}

TEST_F(SettingsFileTest, TakesNamedValuesAndCoupledParameters) {
  const SettingsFile settings =
      Good("knobs:\n  rates: {sets: [c_bump, c_rebound], values: {soft: 1 kN*s/m, hard: 2 kN*s/m}}\n");
  EXPECT_EQ(settings.knobs[0].positions[1].name, "hard");
  EXPECT_THAT(settings.knobs[0].positions[1].values, ElementsAre(2000, 2000));
  EXPECT_EQ(SettingText(settings.knobs, PresentSetting(settings.knobs)), "rates as fitted");
  EXPECT_EQ(AllSettings(settings.knobs).size(), 3U);
}

TEST_F(SettingsFileTest, ReadsRoadsObjectivesAndLimits) {
  const SettingsFile settings = Good(
      "knobs: {spring: {sets: k, values: [10 kN/m, 15 kN/m]}}\n"
      "roads:\n  - {class: B, speed: 72 km/h, weight: 3}\n  - {class: D, speed: 10 m/s, name: track}\n"
      "objectives: {comfort: 3, travel: 1}\nlimits: {least_load: {least: 500 N}, grip: {most: 40 %}}\n"
      "certainty: 95 %\nband: [1 Hz, 20 Hz]\nduration: 10 s\ndraws: 50\nseed: 7\nshortlist: 2\nagreement: 1 %\n"
      "repeatability: 0.5 %\n");
  EXPECT_THAT(settings.RoadWeights(), ElementsAre(0.75, 0.25));
  EXPECT_EQ(settings.roads[0].name, "B 72 km/h");
  EXPECT_NEAR(settings.roads[0].speed, 20, 1e-12);
  EXPECT_EQ(settings.roads[1].name, "track");
  ASSERT_EQ(settings.objectives.size(), 2U);
  EXPECT_EQ(settings.objectives[1].metric, 2U);
  EXPECT_EQ(settings.objectives[1].weight, 0.25);
  ASSERT_EQ(settings.limits.size(), 2U);
  EXPECT_EQ(settings.limits[0].least, 500);
  EXPECT_NEAR(settings.limits[1].MarginOf(0.3), 0.1, 1e-12);
  EXPECT_EQ(settings.certainty, 0.95);
  EXPECT_EQ(settings.upper_Hz, 20);
}

TEST_F(SettingsFileTest, NamesEveryFaultOfAKnobAtItsLine) {
  EXPECT_THAT(Faults("draws: 50\n"), Reports(kKeyMissing, 1, {"knobs"}));
  EXPECT_THAT(Faults("knobs: [a]\n"), Reports(kKnobsNone, 1));
  const std::string one = "knobs:\n  damper:\n    ";
  EXPECT_THAT(Faults(one + "sets: c_bmp\n    values: [1 N*s/m, 2 N*s/m]\n"), Reports(kKnobParameter, 3, {"c_bump"}));
  EXPECT_THAT(Faults(one + "sets: c_bump\n"), Reports(kKnobSource, 3, {"none"}));
  EXPECT_THAT(Faults(one + "sets: c_bump\n    values: [1 N*s/m, 2 N*s/m]\n    table: clicks.csv\n"),
              Reports(kKnobSource, 3, {"'table' and 'values'"}));
  EXPECT_THAT(Faults(one + "sets: []\n    values: [1 N*s/m, 2 N*s/m]\n"), Reports(kKnobSetsNothing, 3));
  EXPECT_THAT(Faults(one + "sets: {c_bump: 0}\n    values: [1 N*s/m, 2 N*s/m]\n"), Reports(kKnobFactor, 3, {"c_bump"}));
  EXPECT_THAT(Faults(one + "sets: c_bump\n    values: [1 N/m, 2 N*s/m]\n"),
              Reports(kKnobUnit, 4, {"'1 N/m'", "N*s/m"}));
  EXPECT_THAT(Faults(one + "sets: [c_bump, k]\n    values: [1 N*s/m, 2 N*s/m]\n"), Reports(kKnobUnit, 3, {"'k'"}));
  EXPECT_THAT(Faults(one + "sets: c_bump\n    values: [1 N*s/m]\n"), Reports(kKnobFew, 3));
  EXPECT_THAT(Faults(one + "sets: c_bump\n    range: {from: 1 N*s/m, to: 1 N*s/m, step: 1 N*s/m}\n"),
              Reports(kKnobRange, 4));
  EXPECT_THAT(Faults(one + "sets: {c_bump: bumps}\n    table: clicks.csv\n"), Reports(kKnobColumn, 3, {"bump"}));
  EXPECT_THAT(Faults(one + "sets: {k: bump}\n    table: clicks.csv\n"), Reports(kKnobUnit, 3, {"bump", "'k'"}));
  EXPECT_THAT(Faults(one + "sets: {c_bump: bump}\n    table: clicks.csv\n    positions: [1, 6]\n"),
              Reports(kKnobOutside, 5, {"'6'", "1 .. 5"}));
  EXPECT_THAT(Faults(one + "sets: {c_bump: bump}\n    table: clicks.csv\n    positions: 3\n"),
              Reports(kKnobPositions, 5));
  EXPECT_THAT(Faults(one + "sets: {c_bump: bump}\n    table: clicks.csv\n    now: 2\n"), Reports(kKnobNow, 5, {"'2'"}));
  EXPECT_THAT(Faults(one + "sets: {c_bump: bump}\n    table: clicks.csv\n    change: ratoi\n"),
              Reports(kKnobChange, 5, {"ratio"}));
  EXPECT_THAT(Faults(one + "sets: {c_bump: bump}\n    table: clicks.csv\n    change: ratio\n"),
              Reports(kKnobChangeWithoutNow, 5));
  EXPECT_THAT(Faults(one + "sets: c_bump\n    values: [-1 N*s/m, 2 N*s/m]\n"), Reports(kKnobSign, 3, {"-1 N*s/m"}));
  EXPECT_THAT(Faults("knobs:\n  a: {sets: k, values: [1 N/m, 2 N/m]}\n  b: {sets: k, values: [1 N/m, 2 N/m]}\n"),
              Reports(kKnobParameterTwice, 3, {"'k'"}));
  // All at once.
  const Diagnostics& all = Faults("knobs:\n  a: {sets: kk, values: [1 N/m, 2 N/m]}\n  b: {sets: k}\ndrawz: 3\n");
  EXPECT_THAT(all, Reports(kKnobParameter, 2));
  EXPECT_THAT(all, Reports(kKnobSource, 3));
  EXPECT_THAT(all, Reports(kKeyUnknown, 4, {"draws"}));
}

TEST_F(SettingsFileTest, NamesFaultsOfTables) {
  const std::string knob = "knobs:\n  damper: {sets: {c_bump: bump}, table: clicks.csv}\n";
  folder_.Write("clicks.csv", "click,bump\n,N*sec/m\n1,500\n2,600\n");
  EXPECT_THAT(Faults(knob), Reports(kPositionsUnit, 2, {"N*sec/m"}));
  folder_.Write("clicks.csv", "click,bump\n,N*s/m\n1,500\n2,x\n");
  EXPECT_THAT(Faults(knob), Reports(kPositionsNumber, 4, {"bump"}));
  folder_.Write("clicks.csv", "click,bump\n,N*s/m\n1,500\n1,600\n");
  EXPECT_THAT(Faults(knob), Reports(kPositionsTwice, 4, {"'1'"}));
  folder_.Write("clicks.csv", "click,bump\n,N*s/m\n1,500\n");
  EXPECT_THAT(Faults(knob), Reports(kPositionsFew, 1));
}

TEST_F(SettingsFileTest, NamesFaultsOfRoadsObjectivesAndLimits) {
  const std::string knob = "knobs: {spring: {sets: k, values: [10 kN/m, 15 kN/m]}}\n";
  EXPECT_THAT(Faults(knob + "roads: B\n"), Reports(kRoadsNone, 2));
  EXPECT_THAT(Faults(knob + "roads: [{class: J, speed: 10 m/s}]\n"), Reports(kRoadClass, 2, {"'J'"}));
  EXPECT_THAT(Faults(knob + "roads: [{class: B, speed: 10}]\n"), Reports(kKeyNotQuantity, 2, {"speed"}));
  EXPECT_THAT(Faults(knob + "roads: [{class: B, speed: 10 m/s}, {class: B, speed: 10 m/s}]\n"), Reports(kRoadTwice, 2));
  EXPECT_THAT(Faults(knob + "objectives: [comfrot]\n"), Reports(kMetricUnknown, 2, {"comfort"}));
  EXPECT_THAT(Faults(knob + "objectives: [least_load]\n"), Reports(kObjectiveNoCost, 2));
  EXPECT_THAT(Faults(knob + "objectives: {comfort: 0}\n"), Reports(kObjectiveWeight, 2));
  EXPECT_THAT(Faults(knob + "objectives: [comfort, comfort]\n"), Reports(kObjectiveTwice, 2));
  EXPECT_THAT(Faults(knob + "objectives: [comfort, grip, travel]\n"), Reports(kObjectivesMany, 2));
  EXPECT_THAT(Faults(knob + "limits: [travel]\n"), Reports(kLimitsNotMapped, 2));
  EXPECT_THAT(Faults(knob + "limits: {travel: {}}\n"), Reports(kLimitEmpty, 2));
  EXPECT_THAT(Faults(knob + "limits: {travel: {most: 10 N}}\n"), Reports(kLimitUnit, 2, {"mm"}));
  EXPECT_THAT(Faults(knob + "limits: {grip: {most: 30}}\n"), Reports(kLimitUnit, 2, {"%"}));
  EXPECT_THAT(Faults(knob + "limits: {travel: {most: 10 mm, least: 20 mm}}\n"), Reports(kLimitReversed, 2));
  EXPECT_THAT(Faults(knob + "certainty: 0.9\n"), Reports(kSettingsShare, 2));
  EXPECT_THAT(Faults(knob + "band: [20 Hz, 10 Hz]\n"), Reports(kBandOutOfRange, 2));
  EXPECT_THAT(Faults(knob + "draws: 1\n"), Reports(kKeyNotInteger, 2));
}

TEST_F(SettingsFileTest, AnObjectiveListMustNameOne) {
  const std::string knob = "knobs: {spring: {sets: k, values: [10 kN/m, 12 kN/m]}}\n";
  for (const char* none : {"objectives: []\n", "objectives: {}\n", "objectives:\n"})
    EXPECT_THAT(Faults(knob + none), Reports(kObjectivesNone)) << none;
}

TEST_F(SettingsFileTest, APositionStandsOnce) {
  EXPECT_THAT(Faults("knobs: {spring: {sets: k, values: [10 kN/m, 12 kN/m, 10 kN/m]}}\n"),
              Reports(kKnobPositionTwice, {"spring", "10 kN/m"}));
}

}  // namespace
}  // namespace fourpost::settings_file_test
