// Parameters of a damper that follow a setting of its recordings, from the study to the cost.
#include <cmath>
#include <cstdio>
#include <string>

#include <gmock/gmock.h>

#include "identify/study/loaded_study.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::controlled_study_test {
namespace {

constexpr const char* kVehicle = R"(<robot name="bench" xmlns:fp="urn:fourpost:vehicle:1"><link name="tube"/>
<link name="rod"><inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="stroke" type="prismatic"><parent link="tube"/><child link="rod"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/>
<limit lower="-1" upper="1" effort="0" velocity="0"/></joint>
<fp:parameter name="c" value="800 N*s/m" lower="0.1 kN*s/m" upper="3 kN*s/m" precision="1 N*s/m" source="guess"/>
<fp:damper name="mr" parent="tube" child="rod"><linear rate="$c"/></fp:damper>
</robot>)";

class ControlledStudy : public testing::Test {
 protected:
  /// Of a damper of this rate.
  void Record(const std::string& name, double rate) const {
    std::string text = "time,displacement,force\ns,m,N\n";
    for (int k = 0; k < 1500; ++k) {
      constexpr double kOmega = 9;
      const double t = 0.001 * k;
      char row[96];
      std::snprintf(row, sizeof row, "%.3f,%.12g,%.12g\n", t, 0.02 * std::sin(kOmega * t),
                    rate * 0.02 * kOmega * std::cos(kOmega * t));
      text += row;
    }
    folder_.Write(name, text);
  }

  std::optional<LoadedStudy> Load(const std::string& law, const std::string& validation = "control: 1 A",
                                  const std::string& free = "") {
    folder_.Write("vehicle.urdf", kVehicle);
    Record("0.csv", 500);
    Record("1.csv", 900);
    Record("2.csv", 1500);
    return LoadStudy(folder_.Write("study.yaml", "vehicle: vehicle.urdf\ncontrol: {c: " + law + "}\n" + free +
                                                     "bench:\n  recordings:\n    - {file: 0.csv, control: 0 A}\n" +
                                                     "    - {file: 2.csv, control: 2 A}\n  validation:\n" +
                                                     "    - {file: 1.csv, " + validation + "}\n"),
                     diagnostics_);
  }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(ControlledStudy, GivesEachSettingAParameter) {
  const std::optional<LoadedStudy> study = Load("per setting");
  ASSERT_TRUE(study) << diagnostics_.Format();
  ASSERT_EQ(study->vehicle.parameters.size(), 2U);
  const Parameter& at_2 = study->vehicle.parameters[1];
  EXPECT_EQ(at_2.name, "c_at_2");
  EXPECT_EQ(at_2.value, 800);
  EXPECT_EQ(at_2.upper, 3000);
  EXPECT_EQ(study->free.size(), 2U);
  EXPECT_NE(study->vehicle.text.find("c_at_2"), std::string::npos);
  // Steps of the bench err by a ten-thousandth.
  EXPECT_LT(study->MakeObjective().Evaluate(Eigen::Vector2d(500, 1500)).residuals.norm(), 1);
  EXPECT_GT(study->MakeObjective().Evaluate(Eigen::Vector2d(1500, 500)).residuals.norm(), 100);
}

TEST_F(ControlledStudy, FreesAllSettingsOfAFreeParameter) {
  const std::optional<LoadedStudy> study = Load("linear", "control: 1 A", "free: [c]\n");
  ASSERT_TRUE(study) << diagnostics_.Format();
  EXPECT_EQ(study->free.size(), 2U);
}

TEST_F(ControlledStudy, LeavesOutAValidationWithoutASetting) {
  const std::optional<LoadedStudy> study = Load("linear", "name: one");
  ASSERT_TRUE(study);
  EXPECT_THAT(diagnostics_, Reports(kValidationLeftOut));
  EXPECT_NE(diagnostics_.Format().find(kSettingMissing.id()), std::string::npos);
}

}  // namespace
}  // namespace fourpost::controlled_study_test
