#include "identify/study_file/control.h"

#include <gmock/gmock.h>

#include "identify/study_file/control_reader.h"
#include "identify/study_file/findings.h"
#include "identify/study_file/study_yaml.h"
#include "tests/findings.h"

namespace fourpost::control_test {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

const std::vector<std::string> kNames = {"c", "yield", "c_at_2", "yield_at_0p5", "yield_at_2"};
/// c = 10 at 0 and 30 at 2; yield = 1, 5, 6 at 0, 0.5, 2.
const std::vector<double> kValues = {10, 1, 30, 5, 6};

Control Damper() { return {{{{.parameter = "c", .is_linear = true}, {.parameter = "yield"}}}, {0, 0.5, 2}, kNames}; }

TEST(Control, LetsParametersFollowALineOrTheirSettings) {
  const Control control = Damper();
  const auto at = [&](double setting) { return control.At(setting).At(kValues); };
  EXPECT_EQ(at(0)[0], 10);
  EXPECT_THAT(at(0.5), ElementsAre(DoubleEq(15), DoubleEq(5), 30, 5, 6));
  EXPECT_THAT(at(1.25), ElementsAre(DoubleEq(22.5), DoubleEq(5.5), 30, 5, 6));
  // Beyond the fit a line goes on and a table ends.
  EXPECT_THAT(at(3), ElementsAre(DoubleEq(40), DoubleEq(6), 30, 5, 6));
  EXPECT_THAT(at(-1), ElementsAre(DoubleEq(0), DoubleEq(1), 30, 5, 6));
}

TEST(Control, OfOneSettingIsTheParameterItself) {
  const Control control({{{.parameter = "c", .is_linear = true}}}, {0.7}, kNames);
  EXPECT_EQ(control.At(5).At(kValues), kValues);
}

TEST(Control, NamesSettingsByLettersAndDigits) {
  EXPECT_EQ(NameAtSetting("c", 1.5), "c_at_1p5");
  EXPECT_EQ(NameAtSetting("c", -12), "c_at_m12");
}

TEST(Control, MissingAndNeedlessSettingsAreFaults) {
  Diagnostics missing;
  SettingOf(Damper(), std::nullopt, "run", {"study.yaml", 7}, missing);
  EXPECT_THAT(missing, Reports(kSettingMissing, 7));
  Diagnostics needless;
  SettingOf({}, 1.0, "run", {"study.yaml", 8}, needless);
  EXPECT_THAT(needless, Reports(kSettingWithoutControl, 8));
}

Diagnostics FaultsOf(const std::string& text) {
  Diagnostics diagnostics;
  const std::optional<YAML::Node> node = ReadYaml(text, "study.yaml", diagnostics);
  const StudyControl control = ReadStudyControl((*node)["control"], "study.yaml", diagnostics);
  if ((*node)["recording"])
    ReadSetting({(*node)["recording"], "the recording", {"control"}, "study.yaml", diagnostics});
  return diagnostics;
}

TEST(Control, IsReadStrictly) {
  EXPECT_EQ(FaultsOf("control: {c: linear, yield: per setting}\nrecording: {control: 1.5 A}").Format(), "");
  EXPECT_THAT(FaultsOf("control: {c: cubic}"), Reports(kControlUnknown, 1));
  EXPECT_THAT(FaultsOf("control: c"), Reports(kControlNotMapped, 1));
  EXPECT_THAT(FaultsOf("control: {c: linear}\nrecording: {control: hard}"), Reports(kSettingNoNumber, 2));
}

}  // namespace
}  // namespace fourpost::control_test
