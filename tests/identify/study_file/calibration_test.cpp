#include "identify/study_file/calibration.h"

#include <gmock/gmock.h>

#include "identify/study_file/calibration_reader.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"

namespace fourpost::calibration_test {
namespace {

std::vector<Calibration> Read(const std::string& text, Diagnostics& findings) {
  return ReadCalibrations(YAML::Load(text), "study.yaml", findings);
}

TEST(Calibration, IsReadInSiUnits) {
  Diagnostics findings;
  const auto list = Read(
      "gain: {accelerometers: 2 %, a_cg: 0.5 %}\n"
      "delay: {posts: 1.5 ms}\n"
      "offset: {static_loads: 0.05 kN}\n",
      findings);
  EXPECT_TRUE(findings.items().empty()) << findings.Format();
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].Name(), "gain of accelerometers");
  EXPECT_EQ(list[0].sd, 0.02);
  EXPECT_EQ(list[1].of, "a_cg");
  EXPECT_EQ(list[2].Name(), "delay of posts");
  EXPECT_EQ(list[2].sd, 1.5e-3);
  EXPECT_EQ(list[2].Unit(), "s");
  EXPECT_EQ(list[3].Name(), "offset of static_loads");
  EXPECT_EQ(list[3].sd, 50);
}

TEST(Calibration, ReportsAllFaultsAtOnce) {
  Diagnostics findings;
  Read(
      "gain: 2 %\n"
      "delay: {posts: 0 ms, static_loads: 1 ms}\n"
      "offset: {load_cells: 10 N}\n",
      findings);
  EXPECT_THAT(findings, Reports(kCalibrationNotMapped));
  EXPECT_THAT(findings, Reports(kCalibrationNotPositive));
  EXPECT_THAT(findings, Reports(kCalibrationDelayAtRest));
  EXPECT_THAT(findings, Reports(kCalibrationOffset));
}

TEST(Calibration, OfAGainIsNotAsLargeAsTheGain) {
  Diagnostics findings;
  Read("gain: {accelerometers: 100 %, a_cg: 50 %}\n", findings);
  EXPECT_EQ(findings.items().size(), 1U);
  EXPECT_THAT(findings, Reports(kCalibrationGainWide, 1, {"accelerometers", "100 %"}));
  findings = {};
  Read("gain: {accelerometers: 1}\n", findings);
  EXPECT_THAT(findings, Reports(kKeyNotQuantity, 1, {"share", "%"}));
}

}  // namespace
}  // namespace fourpost::calibration_test
