#include "vehicles/templates/suspension_vehicle.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/vehicles/lint_all.h"
#include "tests/vehicles/templates/suspension_cars.h"
#include "vehicles/loops/mobility.h"
#include "vehicles/poses/axle_kinematics.h"
#include "vehicles/poses/settled_pose.h"
#include "vehicles/ride/vehicle_summary.h"
#include "vehicles/templates/findings.h"

namespace fourpost::suspension_vehicle_test {
namespace {

using suspension_cars::KindsOf;
using suspension_cars::VehicleOf;

class EachSuspension : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Kinds, EachSuspension, ::testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const SuspensionKind& kind : SuspensionKinds()) names.emplace_back(kind.name);
                           return names;
                         }()),
                         [](const auto& kind) { return kind.param; });

TEST_P(EachSuspension, IsReadAndCheckedWithoutAFinding) {
  const auto kinds = KindsOf(GetParam(), GetParam());
  Diagnostics findings;
  const std::string text = suspension_cars::TextOf(kinds, UsualPoints(kinds), findings);
  const std::optional<Vehicle> vehicle = ReadVehicleText(text, "car.urdf", findings);
  ASSERT_TRUE(vehicle) << findings.Format();
  findings.Add(Lint(*vehicle));
  EXPECT_TRUE(findings.items().empty()) << findings.Format();
}

// XML forbids them, and most parsers but ours refuse them.
TEST_P(EachSuspension, HasNoTwoHyphensInAComment) {
  const auto kinds = KindsOf(GetParam(), GetParam());
  Diagnostics findings;
  const std::string text = suspension_cars::TextOf(kinds, UsualPoints(kinds), findings);
  int comments = 0;
  for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at)) {
    at += 4;
    const std::size_t end = text.find("--", at);
    EXPECT_EQ(text.substr(end, 3), "-->") << text.substr(at, end - at + 20);
    ++comments;
  }
  EXPECT_GE(comments, 3);
}

TEST_P(EachSuspension, WritesEachValueOnce) {
  const auto kinds = KindsOf(GetParam(), GetParam());
  Diagnostics findings;
  const std::string text = suspension_cars::TextOf(kinds, UsualPoints(kinds), findings);
  EXPECT_EQ(text.find("fp:bind"), std::string::npos);
  for (const char* name : {"m_body", "x_body", "I_pitch", "I_roll"})
    EXPECT_NE(text.find("$" + std::string(name)), std::string::npos) << name;
}

TEST_P(EachSuspension, IsAtRestAsDrawnAndMoves) {
  const auto kinds = KindsOf(GetParam(), GetParam());
  const Vehicle vehicle = VehicleOf(kinds, UsualPoints(kinds));
  const std::vector<double> values = vehicle.ParameterValues();
  const Mobility mobility = MobilityOf(vehicle);
  EXPECT_TRUE(mobility.redundant.empty());
  // Six of the body and at least two of each axle.
  EXPECT_GE(mobility.dof, 10);
  const std::optional<SettledPose> rest = Settle(vehicle, values);
  ASSERT_TRUE(rest);
  // Newton's method ends within a micrometre of rest.
  EXPECT_LT(rest->Shift(), 1e-6);
}

// Half the weight of body and wheels stands on either axle but for 3 kg of the wheels; frequencies are those asked for,
// less what tyres and the loads on inclined links change.
TEST_P(EachSuspension, HasTheRideItAsksFor) {
  const auto kinds = KindsOf(GetParam(), GetParam());
  const Vehicle vehicle = VehicleOf(kinds, UsualPoints(kinds));
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  EXPECT_TRUE(summary.IsStable());
  ASSERT_EQ(summary.chassis.axles.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const AxleNumbers& axle = summary.chassis.axles[i];
    EXPECT_NEAR(axle.sprung_kg.value(), 600, 30);
    EXPECT_NEAR(axle.ride_Hz.value(), i == 0 ? 1.2 : 1.4, 0.15);
    EXPECT_GT(axle.hop_Hz.value(), 8);
    EXPECT_LT(axle.hop_Hz.value(), 16);
    EXPECT_GT(axle.roll_on_tyres_Nm.value() * std::numbers::pi / 180, 60);
    EXPECT_LT(axle.roll_on_tyres_Nm.value() * std::numbers::pi / 180, 1200);
  }
  for (const CornerNumbers& corner : summary.chassis.corners) {
    // Twice as much in rebound as in bump, 0.3 in the mean, of the wheel rate that geometry has changed.
    EXPECT_NEAR(corner.bump_ratio.value(), 0.2, 0.03);
    EXPECT_NEAR(corner.rebound_ratio.value(), 0.4, 0.06);
  }
}

TEST_P(EachSuspension, KinematicsReachTheStops) {
  const auto kinds = KindsOf(GetParam(), GetParam());
  const Vehicle vehicle = VehicleOf(kinds, UsualPoints(kinds));
  const std::vector<double> values = vehicle.ParameterValues();
  SuspensionRig rig(vehicle, values);
  const std::vector<AxleKinematics> axles = KinematicsOf(rig, values, {});
  ASSERT_EQ(axles.size(), 2u);
  for (const AxleKinematics& axle : axles) {
    ASSERT_FALSE(axle.travels.empty());
    for (const AxleTravel& travel : axle.travels) {
      EXPECT_EQ(travel.reached_lower, travel.lower) << travel.name;
      EXPECT_EQ(travel.reached_upper, travel.upper) << travel.name;
    }
  }
}

/// A drawing with x to the rear, y to the right, its origin 1.5 m behind the front wheels and 0.2 m above the ground,
/// tilted by 0.01 rad.
std::vector<HardPoint> InAnotherFrame(const std::vector<HardPoint>& points) {
  std::string text = "axle;point;-y (mm);-x (mm);z (mm)\n";
  const double c = std::cos(0.01);
  const double s = std::sin(0.01);
  for (const HardPoint& p : points) {
    char row[160];
    std::snprintf(row, sizeof row, "%s;%s;%.9f;%.9f;%.9f\n", p.axle.c_str(), p.name.c_str(), -1e3 * p.xyz.y(),
                  -1e3 * (c * p.xyz.x() - s * p.xyz.z() - 1.5), 1e3 * (s * p.xyz.x() + c * p.xyz.z() - 0.2));
    text += row;
  }
  Diagnostics findings;
  const std::vector<HardPoint> read = HardPointsOf(text, "other.csv", findings);
  if (!findings.items().empty()) throw FaultyInput(findings);
  return read;
}

TEST(SuspensionVehicle, DoesNotDependOnTheFrameOfTheDrawing) {
  const auto kinds = KindsOf("double_wishbone", "four_link");
  const Vehicle one = VehicleOf(kinds, UsualPoints(kinds));
  Diagnostics findings;
  const std::string text = suspension_cars::TextOf(kinds, InAnotherFrame(UsualPoints(kinds)), findings);
  // The ground rises by 26 mm over the wheelbase.
  EXPECT_THAT(findings, Reports(kGroundSlopes, {"26 mm", "0.57 deg"}));
  const std::optional<Vehicle> other = ReadVehicleText(text, "other.urdf", findings);
  ASSERT_TRUE(other) << findings.Format();
  const auto kinematics = [](const Vehicle& vehicle) {
    const std::vector<double> values = vehicle.ParameterValues();
    SuspensionRig rig(vehicle, values);
    return KinematicsOf(rig, values, {-0.05, 0.05, 0.01});
  };
  const std::vector<AxleKinematics> a = kinematics(one);
  const std::vector<AxleKinematics> b = kinematics(*other);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t t = 0; t < a[i].travels.size(); ++t)
      for (std::size_t k = 0; k < a[i].travels[t].stations.size(); ++k) {
        const WheelPlace& p = a[i].travels[t].stations[k].wheels[0].place;
        const WheelPlace& q = b[i].travels[t].stations[k].wheels[0].place;
        // A nanometre of the points' digits over links of some decimetres.
        EXPECT_NEAR(p.camber, q.camber, 3e-8);
        EXPECT_NEAR(p.toe, q.toe, 3e-8);
        EXPECT_NEAR((p.centre.z() - q.centre.z()), 0, 3e-8);
      }
}

TEST(SuspensionVehicle, HasStaticCamberAndToeOfTheWheelAxis) {
  const auto kinds = KindsOf("macpherson", "twist_beam");
  std::vector<HardPoint> points = UsualPoints(kinds);
  // One degree of negative camber, so that the axis rises outward, and a quarter of a degree of toe-in.
  const double camber = -1 * std::numbers::pi / 180;
  const double toe = 0.25 * std::numbers::pi / 180;
  const Eigen::Vector3d axis(std::cos(camber) * std::sin(toe), std::cos(camber) * std::cos(toe), -std::sin(camber));
  points.push_back({.axle = "front", .name = "wheel_axis", .xyz = Eigen::Vector3d(0, 0.75, 0.31) + 0.1 * axis});
  const Vehicle vehicle = VehicleOf(kinds, points);
  const std::vector<double> values = vehicle.ParameterValues();
  SuspensionRig rig(vehicle, values);
  const AxleKinematics front = KinematicsOf(rig, values, {-0.01, 0.01, 0.01}).at(0);
  const WheelPlace& place = front.travels.at(0).Design().wheels.at(0).place;
  // A nanometre of the file's digits.
  EXPECT_NEAR(place.camber, camber, 1e-8);
  EXPECT_NEAR(place.toe, toe, 1e-8);
  EXPECT_NEAR(place.foot.z(), 0, 2e-9);
}

// In a drawing that is tilted as well, where the height of the centre of mass counts.
TEST(SuspensionVehicle, StandsOnTheLoadsOfItsAxles) {
  const auto kinds = KindsOf("macpherson", "four_link_panhard");
  for (const std::vector<HardPoint>& points : {UsualPoints(kinds), InAnotherFrame(UsualPoints(kinds))}) {
    Diagnostics findings;
    const CarPoints car = SortedPoints(kinds, points, "points.csv", findings);
    const std::string text = SuspensionVehicleText(car, AxleLoads{1040, 830}, "car", "", "points.csv", findings);
    const std::optional<Vehicle> vehicle = ReadVehicleText(text, "car.urdf", findings);
    ASSERT_TRUE(vehicle) << findings.Format();
    const VehicleSummary summary = Summarise(*vehicle, vehicle->ParameterValues());
    // The file states the body's mass to 0.1 kg and its centre to 0.1 mm.
    EXPECT_NEAR(summary.chassis.axles.at(0).load_N / 9.80665, 1040, 0.15);
    EXPECT_NEAR(summary.chassis.axles.at(1).load_N / 9.80665, 830, 0.15);
    EXPECT_NEAR(summary.chassis.axles.at(0).ride_Hz.value(), 1.2, 0.15);
    EXPECT_NEAR(summary.chassis.axles.at(1).ride_Hz.value(), 1.4, 0.15);
  }
  Diagnostics findings;
  const CarPoints car = SortedPoints(kinds, UsualPoints(kinds), "points.csv", findings);
  EXPECT_TRUE(SuspensionVehicleText(car, AxleLoads{100, 100}, "car", "", "points.csv", findings).empty());
  EXPECT_THAT(findings, ReportsOption(kAxleLoadsTooSmall, "--load"));
}

TEST(SuspensionVehicle, APartMayCarryWhatIsNotUsual) {
  const auto kinds = KindsOf("double_wishbone", "trailing_arm");
  std::vector<HardPoint> points = UsualPoints(kinds);
  for (HardPoint& point : points)
    if (point.axle == "front" && point.name == "spring_bottom") {
      point.xyz = {0, 0.57, 0.49};
      point.on = "upper_arm";
    }
  const Vehicle vehicle = VehicleOf(kinds, points);
  for (const Spring& spring : vehicle.springs) {
    if (spring.name != "front_coil_left") continue;
    EXPECT_EQ(vehicle.links.at(static_cast<std::size_t>(spring.line.child.link)).name, "front_upper_arm_left");
  }
}

TEST(SuspensionVehicle, NamesASpringThatDoesNotMove) {
  const auto kinds = KindsOf("trailing_arm", "trailing_arm");
  std::vector<HardPoint> points = UsualPoints(kinds);
  // A centimetre from the arm's axis.
  for (HardPoint& point : points)
    if (point.axle == "rear" && point.name.starts_with("spring")) point.xyz.x() = -2.6 + 0.41;
  Diagnostics findings;
  suspension_cars::TextOf(kinds, points, findings);
  EXPECT_THAT(findings, Reports(kStrutIdle, {"rear", "spring"}));
  EXPECT_FALSE(findings.HasErrors());
}

// A coil that stands on the arm's axis holds nothing.
TEST(SuspensionVehicle, NamesPointsThatMakeNoSuspension) {
  const auto kinds = KindsOf("double_wishbone", "trailing_arm");
  std::vector<HardPoint> points = UsualPoints(kinds);
  for (HardPoint& point : points)
    if (point.axle == "rear" && point.name.starts_with("spring")) point.xyz.x() = -2.6 + 0.42;
  Diagnostics findings;
  EXPECT_TRUE(suspension_cars::TextOf(kinds, points, findings).empty());
  EXPECT_THAT(findings, Reports(kSuspensionDoesNotWork));
}

}  // namespace
}  // namespace fourpost::suspension_vehicle_test
