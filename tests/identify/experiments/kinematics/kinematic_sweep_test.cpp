#include "identify/experiments/kinematics/kinematic_sweep.h"

#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "identify/experiments/kinematics/findings.h"
#include "identify/experiments/kinematics/kinematic_column.h"
#include "identify/experiments/kinematics/kinematic_lint.h"
#include "identify/study/findings.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/identify/experiments/kinematics/rig_study.h"

namespace fourpost::kinematic_sweep_test {
namespace {

using testing::ElementsAre;

constexpr double kDeg = std::numbers::pi / 180;
/// Digits of a table.
constexpr double kRounding = 1e-12;

constexpr const char* kTable = R"(Z [mm],camber_left [deg],camber_right [deg],GAM [rad],motion_ratio_coil_left
-20,0.5,0.6,0.001,0.7
0,0,,0.002,0.71
20,-0.5,-0.6,0.003,0.72
)";

constexpr const char* kPlain = R"(vehicle: car.urdf
kinematics:
  - file: table.csv
    motion: heave
    travel: Z
    noise: {camber: 0.02 deg}
free: [dz_ball]
)";

class KinematicSweepTest : public testing::Test {
 protected:
  KinematicSweepTest() { folder_.Write("table.csv", kTable); }

  std::string With(const std::string& what, const std::string& with) const {
    std::string text = kPlain;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), with);
  }

  /// Of the plain study with `what` replaced.
  Diagnostics Faults(const std::string& what, const std::string& with) const {
    Diagnostics findings;
    EXPECT_FALSE(folder_.Load(With(what, with), findings));
    return findings;
  }

  rig_study::RigFolder folder_;
};

TEST_F(KinematicSweepTest, ReadsColumnsByTheirNames) {
  LoadedStudy study = folder_.Loaded(kPlain);
  const std::vector<KinematicSweep>& sweeps = rig_study::RigOf(study).fitted;
  ASSERT_EQ(sweeps.size(), 1u);
  EXPECT_EQ(sweeps[0].axle_name, "wheel");
  EXPECT_THAT(sweeps[0].positions, ElementsAre(-0.02, 0, 0.02));
  ASSERT_EQ(sweeps[0].curves.size(), 2u);
  EXPECT_EQ(sweeps[0].curves[0].of_name, "wheel_left");
  EXPECT_NEAR(sweeps[0].curves[0].measured[2], -0.5 * kDeg, kRounding);
  // An empty field is no point.
  EXPECT_THAT(sweeps[0].curves[1].places, ElementsAre(0, 2));
  EXPECT_NEAR(sweeps[0].curves[1].sd, 0.02 * kDeg, kRounding);
}

TEST_F(KinematicSweepTest, TakesChannelsWithUnitSignAndScale) {
  LoadedStudy study = folder_.Loaded(With("noise: {camber", R"(channels: {toe_right: {channel: GAM, sign: -1, scale: 2}}
    noise: {toe: 0.01 deg, motion_ratio: 0.001, camber)"));
  const std::vector<KinematicCurve>& curves = rig_study::RigOf(study).fitted[0].curves;
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(curves[0].quantity->name, "toe");
  EXPECT_EQ(curves[0].of_name, "wheel_right");
  EXPECT_NEAR(curves[0].measured[1], -0.004, kRounding);
  EXPECT_EQ(curves[3].of_name, "coil_left");
}

TEST_F(KinematicSweepTest, CountsARepeatedTravelEachTime) {
  folder_.Write("table.csv", "travel [mm],toe_left [deg]\n0,0\n10,0.1\n0,0.02\n");
  LoadedStudy study = folder_.Loaded(R"(vehicle: car.urdf
kinematics: [{file: table.csv, motion: roll, noise: {toe: 0.01 deg}}]
)");
  const KinematicSweep& sweep = rig_study::RigOf(study).fitted.at(0);
  EXPECT_THAT(sweep.positions, ElementsAre(0, 0.01));
  EXPECT_THAT(sweep.curves.at(0).places, ElementsAre(0, 1, 0));
}

constexpr const char* kByRows = R"(vehicle: car.urdf
kinematics:
  - file: table.csv
    noise: {toe: 0.01 deg}
)";

TEST_F(KinematicSweepTest, CountsWhatStandsInRowsOfWheelsAndStrutsOnce) {
  folder_.Write("table.csv", R"(motion,travel [mm],wheel,strut,track [mm],toe [deg],motion_ratio
heave,10,left,coil_left,1500,0.1,0.7
heave,10,left,coil_right,1500,0.1,0.7
heave,10,right,coil_left,1500,0.2,0.7
heave,10,right,coil_right,1500,0.2,0.7
roll,0,right,coil_left,1501,0.3,0.7
roll,10,right,coil_left,1502,0.4,0.7
)");
  LoadedStudy study = folder_.Loaded(R"(vehicle: car.urdf
kinematics: [{file: table.csv, noise: {track: 1 mm, toe: 0.01 deg, motion_ratio: 0.01}}]
)");
  std::vector<std::string> points;
  for (const KinematicSweep& sweep : rig_study::RigOf(study).fitted)
    for (const KinematicCurve& curve : sweep.curves)
      points.push_back(sweep.motion + " " + std::string(curve.quantity->name) + " " + curve.of_name + " " +
                       std::to_string(curve.measured.size()));
  EXPECT_THAT(points, testing::UnorderedElementsAre("heave track wheel 1", "heave toe wheel_left 1",
                                                    "heave toe wheel_right 1", "heave motion_ratio coil_left 1",
                                                    "heave motion_ratio coil_right 1", "roll track wheel 2",
                                                    "roll toe wheel_right 2", "roll motion_ratio coil_left 2"));
}

TEST_F(KinematicSweepTest, RefusesANumberWhoseRowNamesNoWheel) {
  folder_.Write("table.csv", "motion,travel [mm],wheel,toe [deg]\nheave,0,left,0.1\nheave,10,,0.2\nheave,20,,\n");
  Diagnostics findings;
  EXPECT_FALSE(folder_.Load(kByRows, findings));
  EXPECT_THAT(findings, ReportsOnly(kKinematicWheelEmpty, 3, {"toe"}));
}

TEST_F(KinematicSweepTest, TakesThePositionOfEachMotion) {
  folder_.Write("table.csv", R"(motion,travel [mm],force [kN],torque [N*m],toe_left [deg]
heave,10,,,0.1
lateral,,2,,0.2
aligning,,,100,0.3
)");
  LoadedStudy study = folder_.Loaded(kByRows);
  const std::vector<KinematicSweep>& sweeps = rig_study::RigOf(study).fitted;
  ASSERT_EQ(sweeps.size(), 3u);
  EXPECT_THAT(sweeps[0].positions, ElementsAre(0.01));
  EXPECT_THAT(sweeps[1].positions, ElementsAre(2000));
  EXPECT_THAT(sweeps[2].positions, ElementsAre(100));
}

TEST_F(KinematicSweepTest, RefusesATorqueInAColumnOfForces) {
  folder_.Write("table.csv", "load,force [kN],toe_left [deg]\nlateral,1,0.1\naligning,0.1,0.2\n");
  Diagnostics findings;
  EXPECT_FALSE(folder_.Load(kByRows, findings));
  EXPECT_THAT(findings, ReportsOnly(kKinematicPositionMissing, 3, {"torque", "N*m"}));
}

TEST_F(KinematicSweepTest, RefusesALoadOfAnotherDimension) {
  folder_.Write("table.csv", "load,per,toe_left [deg]\naligning,100 N*m,0.1\nlateral,100 N*m,0.1\n");
  Diagnostics findings;
  EXPECT_FALSE(folder_.Load(kByRows, findings));
  EXPECT_THAT(findings, ReportsOnly(kKinematicPer, 3, {"100 N*m", "force", "kN"}));
}

TEST_F(KinematicSweepTest, WarnsOfRowsThatAreNotUsed) {
  folder_.Write("table.csv", "motion,travel [mm],toe_left [deg]\nheave,0,0.1\nheave,,0.2\nheave,,\nheave,,0.3\n");
  Diagnostics findings;
  EXPECT_TRUE(folder_.Load(kByRows, findings));
  EXPECT_THAT(findings, ReportsOnly(kKinematicRowsSkipped, 3, {"2 rows", "line 3", "travel"}));
}

TEST_F(KinematicSweepTest, TakesOtherSpellingsOfAName) {
  folder_.Write("table.csv", "motion,Wheel Travel [mm],Toe angle - left [deg]\nheave,0,0.1\nheave,20,0.2\n");
  LoadedStudy study = folder_.Loaded(kByRows);
  ASSERT_EQ(rig_study::RigOf(study).fitted.size(), 1u);
}

TEST_F(KinematicSweepTest, TakesWordsBelowAnEmptyField) {
  folder_.Write("table.csv", "load,case,force [kN],toe_left [deg]\nlateral,,1,0.1\nlateral,opposed,1,0.2\n");
  LoadedStudy study = folder_.Loaded(kByRows);
  const std::vector<KinematicSweep>& sweeps = rig_study::RigOf(study).fitted;
  ASSERT_EQ(sweeps.size(), 2u);
  EXPECT_FALSE(sweeps[0].load->is_opposed);
  EXPECT_TRUE(sweeps[1].load->is_opposed);
}

TEST(KinematicColumns, HaveTheNamesThatAreMeant) {
  const TemporaryFolder folder;
  const auto name = [&](const std::string& written) {
    Diagnostics findings;
    const auto table = ReadRecordedTable(folder.Write("table.csv", written + " [mm],x\n0,0\n1,1\n"), findings);
    return KinematicColumns(table.value()).front().name;
  };
  EXPECT_EQ(name("Wheel Travel"), "travel");
  EXPECT_EQ(name("Camber FL"), "camber_FL");
  EXPECT_EQ(name("Toe angle - LEFT"), "toe_left");
  EXPECT_EQ(name("camber_tyre_FL"), "camber_tyre_FL");
  // Which of a table's forces loads the wheels, its motion says.
  EXPECT_EQ(name("Lateral Force"), "Lateral Force");
  EXPECT_EQ(name("Travel Sensor"), "travel_Sensor");
}

TEST(KinematicTables, HaveATravelOrALoadAndNoTimes) {
  const TemporaryFolder folder;
  const auto is_one = [&](const std::string& text) {
    Diagnostics findings;
    return IsKinematicTable(ReadRecordedTable(folder.Write("table.csv", text), findings).value());
  };
  EXPECT_TRUE(is_one("travel [mm],camber_left [deg]\n0,0\n1,1\n"));
  EXPECT_TRUE(is_one("force [kN],toe_left [deg]\n0,0\n1,1\n"));
  EXPECT_TRUE(is_one("torque [N*m],toe_left [deg]\n0,0\n1,1\n"));
  EXPECT_TRUE(is_one("Wheel Travel [mm],Camber FL [deg]\n0,0\n1,1\n"));
  EXPECT_FALSE(is_one("Rail Travel [mm],Camber FL [deg]\n0,0\n1,1\n"));
  EXPECT_FALSE(is_one("time [s],travel [mm],camber_left [deg]\n0,0,0\n1,1,1\n"));
  EXPECT_FALSE(is_one("clock [s],force [kN],toe_left [deg]\n0,0,0\n1,1,1\n"));
  EXPECT_FALSE(is_one("force [kN],length [mm]\n0,0\n1,1\n"));
}

TEST_F(KinematicSweepTest, RefusesWhatTheTableLacks) {
  EXPECT_THAT(Faults("camber: 0.02 deg", "toe: 0.01 deg"), ReportsOnly(kKinematicQuantityMissing, 3, {"toe", "GAM"}));
  EXPECT_THAT(Faults("travel: Z", "travel: X"), ReportsOnly(kKinematicChannelMissing, 3, {"X"}));
  EXPECT_THAT(Faults("    travel: Z\n", ""), ReportsOnly(kKinematicPositionMissing, 3, {"travel", "mm"}));
  EXPECT_THAT(Faults("travel: Z", "channels: {camber_left: GAM_L}\n    travel: Z"),
              Reports(kKinematicChannelMissing, 3, {"GAM_L"}));
  EXPECT_THAT(Faults("travel: Z", "channels: {camber_middle: GAM}\n    travel: Z"),
              Reports(kKinematicQuantityUnknown, 5, {"camber_middle"}));
  EXPECT_THAT(Faults("travel: Z", "channels: {camber: GAM}\n    travel: Z"),
              Reports(kKinematicWheelOpen, 3, {"GAM", "camber_left"}));
}

TEST_F(KinematicSweepTest, RefusesOtherUnitsAndNoNumbers) {
  EXPECT_THAT(Faults("motion: heave", "motion: lateral"), Reports(kKinematicColumnUnit, 3, {"Z", "mm", "kN"}));
  folder_.Write("table.csv", "Z,camber_left [deg]\n0,0\n20,1\n");
  EXPECT_THAT(Faults("free", "search: {seed: 1}\nfree"), ReportsOnly(kKinematicColumnUnit, 3, {"Z", "no unit"}));
  folder_.Write("table.csv", "Z [mm],camber_left [deg]\n0,0\n20,1x\n");
  EXPECT_THAT(Faults("free", "search: {seed: 1}\nfree"), ReportsOnly(kKinematicNumber, 3, {"camber_left", "1x"}));
}

TEST_F(KinematicSweepTest, RefusesAxlesAndMotionsThatAreNotThere) {
  EXPECT_THAT(Faults("motion: heave", "axle: rear"), Reports(kKinematicAxleUnknown, 3, {"rear", "wheel"}));
  EXPECT_THAT(Faults("    motion: heave\n", ""), ReportsOnly(kKinematicMotionOpen, 3));
  EXPECT_THAT(Faults("motion: heave", "motion: heav"), ReportsOnly(kKinematicMotionUnknown, 3, {"heav", "heave"}));
}

TEST_F(KinematicSweepTest, RefusesTravelsThatTheSuspensionDoesNotReach) {
  folder_.Write("table.csv", "Z [m],camber_left [deg]\n0,0\n0.5,1\n");
  EXPECT_THAT(Faults("free", "search: {seed: 1}\nfree"), ReportsOnly(kKinematicNotReached, 3, {"heave", "500 mm"}));
}

TEST_F(KinematicSweepTest, RefusesComplianceOfARigidLinkage) {
  folder_.Write("car.urdf", axle_cars::DoubleWishbone());
  folder_.Write("table.csv", "force [kN],toe_left [deg]\n0,0\n1,0.1\n");
  Diagnostics findings;
  EXPECT_FALSE(folder_.Load(
      "vehicle: car.urdf\nkinematics:\n  - {file: table.csv, motion: lateral, noise: {toe: 0.01 deg}}\n", findings));
  EXPECT_THAT(findings, Reports(kKinematicRigid, 3, {"table", "wheel"}));
}

TEST_F(KinematicSweepTest, RefusesPositionsThatItWouldNotUse) {
  EXPECT_THAT(Faults("travel: Z", "travel: Z\n    force: Z"),
              ReportsOnly(kKinematicPositionTwice, 6, {"force", "travel"}));
  EXPECT_THAT(Faults("travel: Z", "travel: {channel: Z, offset: 3 mm}"), ReportsOnly(kKeyUnknown, 5, {"'offset'"}));
  LoadedStudy study =
      folder_.Loaded(With("motion: heave\n    travel: Z", "motion: aligning\n    torque: {channel: Z, unit: N*m}"));
  EXPECT_THAT(rig_study::RigOf(study).fitted.at(0).positions, ElementsAre(-20, 0, 20));
}

TEST_F(KinematicSweepTest, RefusesPlansThatSayNothing) {
  EXPECT_THAT(Faults("camber: 0.02 deg", "camber: 2 %"), ReportsOnly(kKinematicAngleUnit, 6, {"camber", "2 %"}));
  EXPECT_THAT(Faults("camber: 0.02", "cambre: 0.02"), Reports(kKinematicQuantityUnknown, 6, {"cambre", "camber"}));
  EXPECT_THAT(Faults("noise: {camber", "offset: [toe]\n    noise: {camber"),
              Reports(kKinematicOffsetOfNone, 6, {"toe"}));
  EXPECT_THAT(Faults("noise: {camber", "use: validation\n    noise: {camber"), Reports(kKinematicsNotFitted, 3));
}

TEST_F(KinematicSweepTest, RefusesAFreeOffsetOfOnePoint) {
  folder_.Write("table.csv", "Z [mm],camber_left [deg]\n10,1\n");
  EXPECT_THAT(Faults("noise: {camber", "offset: free\n    noise: {camber"),
              ReportsOnly(kKinematicOnePoint, 3, {"camber"}));
}

TEST_F(KinematicSweepTest, OtherExperimentsDoNotFollowPoints) {
  folder_.Write("loads.csv", "quantity,unit,value,sd\nload,N,3000,10\n");
  EXPECT_THAT(Faults("free", "static_loads: {file: loads.csv, tyres: {wheel_left: load}}\nfree"),
              ReportsOnly(kFreeMovesPoints, 8, {"dz_ball"}));
}

TEST_F(KinematicSweepTest, WarnsOfCurvesThatGoTheOtherWay) {
  LoadedStudy study = folder_.Loaded();
  KinematicsRig& rig = rig_study::RigOf(study);
  Diagnostics findings;
  rig.Check(study.MakeSubject(), Severity::kError, findings);
  EXPECT_EQ(findings.Format(), "");
  for (double& value : rig.fitted.at(0).curves.at(0).measured) value = -value;
  rig.Check(study.MakeSubject(), Severity::kError, findings);
  EXPECT_THAT(findings, ReportsOnly(kKinematicOpposite, 3, {"camber", "wheel_left", "sign: -1"}));
}

TEST(KinematicSigns, AreThoseAboutAFreeOffsetUnderALoad) {
  KinematicSweep sweep{.motion = "lateral", .load = KinematicSweep::Load{}, .positions = {-1000, 1000}};
  sweep.curves.push_back({.quantity = FindKinematicQuantity("toe"),
                          .of_name = "wheel_left",
                          .places = {0, 1},
                          .measured = {5.01, 4.99},
                          .sd = 0.001});
  KinematicCurve& curve = sweep.curves[0];
  const std::vector<KinematicMisfit> misfits = {
      {.sweep = &sweep, .curve = &curve, .modelled = Eigen::Vector2d(-0.01, 0.01)}};
  Diagnostics findings;
  LintKinematicSigns(misfits, "study.yaml", findings);
  EXPECT_EQ(findings.Format(), "");
  curve.has_free_offset = true;
  LintKinematicSigns(misfits, "study.yaml", findings);
  EXPECT_THAT(findings, Reports(kKinematicOpposite, 0, {"toe"}));
}

TEST_F(KinematicSweepTest, WarnsOfAConstantDifference) {
  LoadedStudy study = folder_.Loaded();
  KinematicsRig& rig = rig_study::RigOf(study);
  for (double& value : rig.fitted.at(0).curves.at(0).measured) value += 0.5 * kDeg;
  const std::vector<double> truth = {rig_study::kBall_m, rig_study::kTie_m, rig_study::kBush_Npm};
  const KinematicModel model(study.vehicle, rig.fitted);
  Diagnostics findings;
  LintKinematicOffsets(KinematicMisfits(rig.fitted, model.At(truth)), "study.yaml", findings);
  EXPECT_THAT(findings, ReportsOnly(kKinematicConstantOff, 3, {"camber", "0.500 deg", "offset: [camber]"}));
}

}  // namespace
}  // namespace fourpost::kinematic_sweep_test
