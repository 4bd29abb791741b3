#include "vehicles/poses/axle_kinematics.h"

#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/poses/axle_cars.h"
#include "tests/vehicles/poses/newton_solver.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::axle_kinematics_test {
namespace {

using axle_cars::Vec;
using newton::Place;

/// Two solvers that close loops to 1e-13 of metres, differences over 0.1 mm of theirs for what is a rate.
constexpr double kSame = 1e-9;
constexpr double kSameRate = 1e-6;

AxleKinematics KinematicsOfAxle(const std::string& text, const TravelRange& range) {
  const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / ("fourpost_axle_" + name + ".urdf");
  std::ofstream(file) << text;
  Diagnostics findings;
  const std::optional<Vehicle> vehicle = ReadVehicle(file, findings);
  std::filesystem::remove(file);
  if (!vehicle) throw FaultyInput(findings);
  const std::vector<double> values = vehicle->ParameterValues();
  SuspensionRig rig(*vehicle, values);
  return KinematicsOf(rig, values, range).at(0);
}

constexpr TravelRange Range(double lower, double upper, double step) { return {lower, upper, step}; }

const AxleTravel& TravelNamed(const AxleKinematics& kinematics, const std::string& name) {
  for (const AxleTravel& travel : kinematics.travels)
    if (travel.name == name) return travel;
  throw std::out_of_range(name);
}

double RatioOf(const AxleKinematics& kinematics, const AxleStation& station, const std::string& strut) {
  for (std::size_t i = 0; i < kinematics.struts.size(); ++i)
    if (kinematics.struts[i].name == strut) return station.ratios[i];
  throw std::out_of_range(strut);
}

/// Axes of a left wheel as drawn: the link is turned by x, then z, as URDF's rpy are.
Vec DrawnAxis(const Vec& turn) {
  Eigen::Matrix3d about_x;
  about_x << 1, 0, 0, 0, std::cos(turn.x()), -std::sin(turn.x()), 0, std::sin(turn.x()), std::cos(turn.x());
  Eigen::Matrix3d about_z;
  about_z << std::cos(turn.z()), -std::sin(turn.z()), 0, std::sin(turn.z()), std::cos(turn.z()), 0, 0, 0, 1;
  return about_z * about_x * Vec::UnitY();
}

Vec FootOf(const Vec& centre, const Vec& axis) {
  const Vec up = Vec::UnitZ() - axis.z() * axis;
  return centre - axle_cars::kRadius * up.normalized();
}

/// A left wheel whose carrier goes where its equations allow, at each rise of the centre.
struct OneWheel {
  std::function<Place(double rise)> place;
  Vec axis = Vec::UnitY();
  axle_cars::Link2 coil;
  /// Where the lower end of the coil has gone; empty: it moves with the carrier.
  std::function<Vec(double rise)> coil_end;

  Vec Centre(double rise) const { return place(rise)(axle_cars::kWheel); }
  Vec Axis(double rise) const { return place(rise).Rotation() * axis; }
  Vec Foot(double rise) const { return FootOf(Centre(rise), Axis(rise)); }
  double CoilLength(double rise) const {
    return ((coil_end ? coil_end(rise) : place(rise)(coil.outer)) - coil.inner).norm();
  }
};

/// Every number of a symmetric axle with independent wheels over heave, and of one wheel alone.
void ExpectSame(const AxleKinematics& kinematics, const OneWheel& wheel) {
  constexpr double kStep = 1e-4;
  const AxleTravel& heave = TravelNamed(kinematics, "heave");
  ASSERT_EQ(heave.stations.size(), 13u);
  for (const std::string name : {"heave", "wheel_left"})
    for (const AxleStation& station : TravelNamed(kinematics, name).stations) {
      SCOPED_TRACE(name + " at " + std::to_string(station.travel));
      const double t = station.travel;
      const WheelPlace& left = station.wheels.at(0).place;
      const Vec axis = wheel.Axis(t);
      EXPECT_NEAR(left.camber, -std::asin(axis.z()), kSame);
      EXPECT_NEAR(left.toe, std::atan2(axis.x(), axis.y()), kSame);
      EXPECT_NEAR((left.centre - wheel.Centre(t)).norm(), 0, kSame);
      EXPECT_NEAR((left.foot - wheel.Foot(t)).norm(), 0, kSame);
      EXPECT_NEAR(station.wheels[0].rise, t, kSame);
      EXPECT_NEAR(RatioOf(kinematics, station, "coil_left"),
                  (wheel.CoilLength(t - kStep) - wheel.CoilLength(t + kStep)) / (2 * kStep), kSameRate);
      if (name != "heave") continue;
      const WheelPlace& right = station.wheels.at(1).place;
      EXPECT_NEAR(right.camber, left.camber, kSame);
      EXPECT_NEAR(right.toe, left.toe, kSame);
      EXPECT_NEAR(station.track.value(), 2 * wheel.Foot(t).y(), kSame);
      // Where the line across the foot's path meets the middle.
      const Vec path = (wheel.Foot(t + kStep) - wheel.Foot(t - kStep)) / (2 * kStep);
      EXPECT_NEAR(station.roll_centre.value(), wheel.Foot(t).y() * path.y() / path.z(), kSameRate);
      EXPECT_NEAR(station.wheels[0].rate.camber,
                  -(std::asin(wheel.Axis(t + kStep).z()) - std::asin(wheel.Axis(t - kStep).z())) / (2 * kStep),
                  kSameRate);
    }
  // Opposite travels of both wheels are those of each.
  for (const AxleStation& station : TravelNamed(kinematics, "roll").stations) {
    const double t = station.travel;
    EXPECT_NEAR(station.wheels.at(0).place.toe, std::atan2(wheel.Axis(-t).x(), wheel.Axis(-t).y()), kSame);
    EXPECT_NEAR(station.wheels.at(1).place.toe, std::atan2(wheel.Axis(t).x(), wheel.Axis(t).y()), kSame);
    const Vec across = wheel.Foot(-t) + Vec(0, wheel.Foot(t).y(), -wheel.Foot(t).z());
    EXPECT_NEAR(station.roll, std::atan2(-across.z(), across.y()), kSame);
  }
}

Eigen::VectorXd Vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

double Rise(const Place& place) { return place(axle_cars::kWheel).z() - axle_cars::kWheel.z(); }

/// Turns of a point about a line.
Vec Turned(const axle_cars::Link2& axis, double angle, const Vec& point) {
  const Place turn{Vec::Zero(), angle * (axis.outer - axis.inner).normalized()};
  return axis.inner + turn.Rotation() * (point - axis.inner);
}

TEST(AxleKinematics, DoubleWishbone) {
  const auto place = [](double rise) {
    return newton::Solve([&](const Place& at) {
      using axle_cars::kLower, axle_cars::kUpper, axle_cars::kTrackRod;
      return Vector({newton::Rod(at, kLower.front, kLower.ball), newton::Rod(at, kLower.rear, kLower.ball),
                     newton::Rod(at, kUpper.front, kUpper.ball), newton::Rod(at, kUpper.rear, kUpper.ball),
                     newton::Rod(at, kTrackRod.inner, kTrackRod.outer), Rise(at) - rise});
    });
  };
  // The coil stands on the lower arm, which turns as its ball goes.
  const auto coil_end = [&](double rise) {
    using axle_cars::kLower, axle_cars::kWishboneCoil;
    const Vec ball = place(rise)(kLower.ball);
    const axle_cars::Link2 axis{kLower.front, kLower.rear};
    const Vec along = (axis.outer - axis.inner).normalized();
    const auto across = [&](const Vec& p) { return Vec((p - axis.inner) - along.dot(p - axis.inner) * along); };
    const Vec from = across(kLower.ball);
    const Vec to = across(ball);
    return Turned(axis, std::atan2(along.dot(from.cross(to)), from.dot(to)), kWishboneCoil.outer);
  };
  ExpectSame(KinematicsOfAxle(axle_cars::DoubleWishbone(), Range(-0.06, 0.06, 0.01)),
             {place, DrawnAxis(axle_cars::kTurn), axle_cars::kWishboneCoil, coil_end});
}

TEST(AxleKinematics, MacPhersonStrut) {
  const auto place = [](double rise) {
    return newton::Solve([&](const Place& at) {
      using axle_cars::kStrutArm, axle_cars::kStrutRod, axle_cars::kStrutTop, axle_cars::kStrutFoot;
      // The body's top mount lies on the strut's line.
      const Vec along = (at(kStrutTop) - at(kStrutFoot)).normalized();
      const Vec aside = (kStrutTop - at(kStrutFoot)).cross(along);
      return Vector({newton::Rod(at, kStrutArm.front, kStrutArm.ball), newton::Rod(at, kStrutArm.rear, kStrutArm.ball),
                     newton::Rod(at, kStrutRod.inner, kStrutRod.outer), aside.x(), aside.y(), Rise(at) - rise});
    });
  };
  ExpectSame(KinematicsOfAxle(axle_cars::MacPherson(), Range(-0.06, 0.06, 0.01)),
             {place, DrawnAxis(axle_cars::kTurn), {axle_cars::kStrutTop, axle_cars::kStrutFoot}, {}});
}

TEST(AxleKinematics, FiveLinks) {
  const auto place = [](double rise) {
    return newton::Solve([&](const Place& at) {
      std::vector<double> errors = {Rise(at) - rise};
      for (const axle_cars::Link2& link : axle_cars::kFiveLinks)
        errors.push_back(newton::Rod(at, link.inner, link.outer));
      return Vector(errors);
    });
  };
  ExpectSame(KinematicsOfAxle(axle_cars::FiveLink(), Range(-0.06, 0.06, 0.01)),
             {place, DrawnAxis(axle_cars::kTurn), axle_cars::kFiveLinkCoil, {}});
}

/// Turns about its axis until the wheel has risen: closed but for the angle.
Place AboutAxis(const axle_cars::Link2& axis, double rise) {
  double angle = 0;
  for (int i = 0; i < 50; ++i) {
    const auto height = [&](double a) { return Turned(axis, a, axle_cars::kWheel).z() - axle_cars::kWheel.z() - rise; };
    angle -= height(angle) * 2e-6 / (height(angle + 1e-6) - height(angle - 1e-6));
  }
  Place place{Vec::Zero(), angle * (axis.outer - axis.inner).normalized()};
  place.shift = Turned(axis, angle, Vec::Zero());
  return place;
}

TEST(AxleKinematics, SemiTrailingArm) {
  ExpectSame(KinematicsOfAxle(axle_cars::OnOneAxis(axle_cars::kSemiTrailingAxis), Range(-0.06, 0.06, 0.01)),
             {[](double rise) { return AboutAxis(axle_cars::kSemiTrailingAxis, rise); },
              DrawnAxis(axle_cars::kTurn),
              axle_cars::kArmCoil,
              {}});
}

// z = 0.03 below the pivot and 0.45 behind it: rise = 0.45 sin t + 0.03 (1 - cos t). Its wheel keeps the angle between
// its axis and the lateral direction, about which it turns: camber and toe change into each other.
TEST(AxleKinematics, TrailingArmInClosedForm) {
  const AxleKinematics kinematics =
      KinematicsOfAxle(axle_cars::OnOneAxis(axle_cars::kTrailingAxis), Range(-0.06, 0.06, 0.01));
  for (const AxleStation& station : TravelNamed(kinematics, "heave").stations) {
    const double radius = std::hypot(0.45, 0.03);
    const double t = std::asin((station.travel - 0.03) / radius) + std::atan2(0.03, 0.45);
    const Vec drawn = DrawnAxis(axle_cars::kTurn);
    const WheelPlace& left = station.wheels.at(0).place;
    EXPECT_NEAR(left.camber, -std::asin(drawn.z() * std::cos(t) - drawn.x() * std::sin(t)), kSame);
    EXPECT_NEAR(left.toe, std::atan2(drawn.x() * std::cos(t) + drawn.z() * std::sin(t), drawn.y()), kSame);
    EXPECT_NEAR(left.centre.x(), 0.45 - 0.45 * std::cos(t) - 0.03 * std::sin(t), kSame);
    EXPECT_NEAR(left.centre.y(), 0.75, kSame);
    // The coil's foot is 0.25 behind and 0.03 below the pivot, its top 0.29 above.
    const auto length = [](double a) {
      const Vec foot(0.45 - 0.25 * std::cos(a) - 0.03 * std::sin(a), 0, 0.33 + 0.25 * std::sin(a) - 0.03 * std::cos(a));
      return (Vec(0.2, 0, 0.62) - foot).norm();
    };
    const double per_turn = 0.45 * std::cos(t) + 0.03 * std::sin(t);
    EXPECT_NEAR(RatioOf(kinematics, station, "coil_left"), (length(t - 1e-5) - length(t + 1e-5)) / 2e-5 / per_turn,
                kSameRate);
  }
}

TEST(AxleKinematics, BeamAxleOnThreeLinksAndAPanhardRod) {
  using axle_cars::kWheel, axle_cars::Mirrored;
  const auto place = [](double left, double right) {
    return newton::Solve([&](const Place& at) {
      std::vector<double> errors = {at(kWheel).z() - kWheel.z() - left, at(Mirrored(kWheel)).z() - kWheel.z() - right};
      for (const axle_cars::Link2& link : axle_cars::kBeamLinks)
        errors.push_back(newton::Rod(at, link.inner, link.outer));
      return Vector(errors);
    });
  };
  const AxleKinematics kinematics = KinematicsOfAxle(axle_cars::BeamAxle(), Range(-0.06, 0.06, 0.01));
  const auto rises = [](const std::string& name, double t) {
    return name == "heave" ? std::pair(t, t) : name == "roll" ? std::pair(-t, t) : std::pair(t, 0.0);
  };
  const auto feet = [&](const Place& at) {
    const Vec axis = at.Rotation().col(1);
    return std::pair(FootOf(at(kWheel), axis), FootOf(at(Mirrored(kWheel)), axis));
  };
  const auto coil = [&](const Place& at) {
    return (at(axle_cars::kBeamCoil.outer) - axle_cars::kBeamCoil.inner).norm();
  };
  constexpr double kStep = 1e-4;
  for (const std::string name : {"heave", "roll", "wheel_left"})
    for (const AxleStation& station : TravelNamed(kinematics, name).stations) {
      SCOPED_TRACE(name + " at " + std::to_string(station.travel));
      const auto [left, right] = rises(name, station.travel);
      const Place at = place(left, right);
      const Vec axis = at.Rotation().col(1);
      EXPECT_NEAR(station.wheels.at(0).place.camber, -std::asin(axis.z()), kSame);
      EXPECT_NEAR(station.wheels.at(1).place.camber, std::asin(axis.z()), kSame);
      EXPECT_NEAR(station.wheels.at(0).place.steer, std::atan2(-axis.x(), axis.y()), kSame);
      EXPECT_NEAR((station.wheels[0].place.centre - at(kWheel)).norm(), 0, kSame);
      EXPECT_NEAR((station.wheels[1].place.foot - feet(at).second).norm(), 0, kSame);
      EXPECT_NEAR(station.track.value(), feet(at).first.y() - feet(at).second.y(), kSame);
      const auto length = [&](double more) {
        const auto [l, r] = rises(name, station.travel + more);
        return coil(place(l, r));
      };
      EXPECT_NEAR(RatioOf(kinematics, station, "coil_left"), (length(-kStep) - length(kStep)) / (2 * kStep), kSameRate);
      if (name != "heave") continue;
      const auto rolled = [&](double t) { return feet(place(station.travel - t, station.travel + t)); };
      const auto [left_up, right_up] = rolled(kStep);
      const auto [left_down, right_down] = rolled(-kStep);
      const double aside = (left_up.y() + right_up.y() - left_down.y() - right_down.y()) / 2;
      const double turn = (right_up.z() - left_up.z() - right_down.z() + left_down.z()) / station.track.value();
      EXPECT_NEAR(station.roll_centre.value(), -aside / turn, kSameRate);
    }
}

// Level trailing rods would put the roll centre where the Panhard rod crosses the middle of the car. Those of this axle
// slope, which tilts the roll axis.
TEST(AxleKinematics, RollCentreOfABeamIsAboutThePanhardRod) {
  const AxleKinematics kinematics = KinematicsOfAxle(axle_cars::BeamAxle(), Range(-0.01, 0.01, 0.01));
  const double crossing = 0.42 - 0.06 * 0.45 / 0.95;
  EXPECT_NEAR(TravelNamed(kinematics, "heave").Design().roll_centre.value(), crossing, 0.03);
}

// In the design pose loads and rates are those of the reduced model.
TEST(AxleKinematics, AgreesWithTheReducedModelInTheDesignPose) {
  for (const char* name : {"independent_roadster", "landrover110_rigid", "landrover110_model3"}) {
    SCOPED_TRACE(name);
    const Vehicle vehicle = ShippedVehicle(name);
    const std::vector<double> values = vehicle.ParameterValues();
    const VehicleSummary summary = Summarise(vehicle, values);
    SuspensionRig rig(vehicle, values);
    for (const AxleKinematics& kinematics : KinematicsOf(rig, values, Range(-0.01, 0.01, 0.01))) {
      const Axle& axle = summary.suspension.axles[kinematics.axle];
      const AxleTravel& heave = TravelNamed(kinematics, "heave");
      for (std::size_t k = 0; k < axle.wheels.size(); ++k) {
        const double load = summary.corner_loads[axle.wheels[k]].load_N;
        EXPECT_NEAR(heave.Design().wheels[k].load, load, 1e-6 * load);  // typed numbers
        // Differences over 10 mm: the square of the step.
        const double rate = (heave.stations.back().wheels[k].load - heave.stations.front().wheels[k].load) / 0.02;
        EXPECT_NEAR(rate / summary.ride.wheels[axle.wheels[k]].together.wheel_Npm, 1, 0.01);
      }
      for (std::size_t i = 0; i < kinematics.struts.size(); ++i) {
        if (kinematics.struts[i].kind != AxleStrut::Kind::kSpring) continue;
        const StrutGeometry& strut = summary.ride.springs[kinematics.struts[i].index];
        EXPECT_NEAR(heave.Design().ratios[i], strut.together.value(), 1e-6) << kinematics.struts[i].name;
      }
    }
  }
}

// A trailing arm of 0.451 m, 0.03 below its pivot, is upright after 0.481 m.
TEST(AxleKinematics, ReportsADeadCentre) {
  const AxleKinematics kinematics =
      KinematicsOfAxle(axle_cars::OnOneAxis(axle_cars::kTrailingAxis), Range(-0.05, 0.60, 0.05));
  const AxleTravel& heave = TravelNamed(kinematics, "heave");
  EXPECT_EQ(heave.reached_lower, -0.05);
  EXPECT_NEAR(heave.reached_upper, 0.03 + std::hypot(0.45, 0.03), 2e-4);
  EXPECT_LE(heave.reached_upper, 0.03 + std::hypot(0.45, 0.03));
  EXPECT_NEAR(heave.stations.back().travel, 0.45, kSame);
}

// A wheel on a bearing stands as one that is fixed to its upright, and is no compliance.
TEST(AxleKinematics, WheelsDoNotSpin) {
  std::string text = axle_cars::DoubleWishbone();
  const AxleKinematics fixed = KinematicsOfAxle(text, Range(-0.05, 0.05, 0.05));
  const std::size_t joint = text.find("<joint name=\"hub_left\" type=\"fixed\">");
  ASSERT_NE(joint, std::string::npos);
  text.insert(text.find("</joint>", joint), "<axis xyz=\"0 1 0\"/>");
  text.replace(text.find("fixed", joint), 5, "continuous");
  const AxleKinematics spinning = KinematicsOfAxle(text, Range(-0.05, 0.05, 0.05));
  EXPECT_TRUE(spinning.compliance.empty());
  for (std::size_t i = 0; i < 3; ++i) {
    const WheelPlace& a = TravelNamed(fixed, "heave").stations.at(i).wheels.at(0).place;
    const WheelPlace& b = TravelNamed(spinning, "heave").stations.at(i).wheels.at(0).place;
    EXPECT_NEAR(a.camber, b.camber, kSame);
    EXPECT_NEAR(a.toe, b.toe, kSame);
    EXPECT_NEAR((a.foot - b.foot).norm(), 0, kSame);
  }
}

TEST(AxleKinematics, RigidLinkageHasNoCompliance) {
  EXPECT_TRUE(KinematicsOfAxle(axle_cars::DoubleWishbone(), Range(-0.01, 0.01, 0.01)).compliance.empty());
}

/// A wheel's carrier on one bush at (0, 0.5, 0.3) and a coil over the wheel's centre; bodies of some grams, so that the
/// coil's load does not stiffen the bush by a share of 1e-5.
std::string OnOneBush() {
  std::string text =
      axle_cars::Car(axle_cars::Body("upright_left", 0.001) + axle_cars::Floating("upright_left") +
                     axle_cars::Frame("seat_left", "body", {0, 0.5, 0.3}) +
                     axle_cars::Frame("pin_left", "upright_left", {0, 0.5, 0.3}) +
                     "<fp:bushing name=\"bush_left\" parent=\"seat_left\" child=\"pin_left\" "
                     "preload=\"equilibrium\"><translation x=\"2 "
                     "kN/mm\" y=\"3 kN/mm\" z=\"4 kN/mm\"/><rotation x=\"50 kN*m/rad\" y=\"60 kN*m/rad\" z=\"70 "
                     "kN*m/rad\"/></fp:bushing>\n" +
                     axle_cars::Coil("coil_left", "upright_left", {0, 0.75, 0.8}, {0, 0.75, 0.3}) +
                     axle_cars::Tyre("wheel_left", "upright_left", axle_cars::kWheel));
  const std::string heavy = "<mass value=\"600.000000\"/>";
  text.replace(text.find(heavy), heavy.size(), "<mass value=\"0.01\"/>");
  for (std::size_t at = 0; (at = text.find("ixx=\"0.1\"", at)) != std::string::npos;)
    text.replace(at, 9, "ixx=\"1e-3\"");
  return text;
}

TEST(AxleKinematics, ComplianceOfOneBushInClosedForm) {
  const AxleKinematics kinematics = KinematicsOfAxle(OnOneBush(), Range(-0.01, 0.01, 0.01));
  constexpr double kShare = 1e-5;
  constexpr double l = 0.25;
  constexpr double r = axle_cars::kRadius;
  const auto left = [&](WheelLoad load) {
    for (const AxleCompliance& compliance : kinematics.compliance)
      if (compliance.load == load && !compliance.is_opposed) return compliance.wheels.at(0);
    throw std::out_of_range("load");
  };
  // A force across the foot turns the bush about x; the pad's height adds a force that keeps the centre where it is.
  const WheelPlace lateral = left(WheelLoad::kLateral);
  EXPECT_NEAR(lateral.centre.y() * 3e6, 1, kShare);
  const double pad = -(l * r / 50e3) / (1 / 4e6 + l * l / 50e3);
  EXPECT_NEAR(-lateral.camber / ((l * pad + r) / 50e3), 1, 1e-4);  // a small rest of large parts
  EXPECT_NEAR(lateral.steer, 0, kShare / 70e3);
  const WheelPlace braking = left(WheelLoad::kBraking);
  EXPECT_NEAR(braking.steer / (l / 70e3), 1, kShare);
  EXPECT_NEAR(braking.toe, -braking.steer, kShare / 70e3);
  EXPECT_NEAR(braking.centre.x() / -(1 / 2e6 + l * l / 70e3), 1, kShare);
  const WheelPlace driving = left(WheelLoad::kDriving);
  EXPECT_NEAR(driving.centre.x() / (1 / 2e6 + l * l / 70e3), 1, kShare);
  const WheelPlace aligning = left(WheelLoad::kAligning);
  EXPECT_NEAR(aligning.steer * 70e3, 1, kShare);
  EXPECT_NEAR(aligning.centre.x() / (-l / 70e3), 1, kShare);
}

// A stop over the wheel's centre that is met after 45 mm, and none in rebound: not beyond it, whatever the step.
TEST(AxleKinematics, ReachesToTheStops) {
  std::string text = OnOneBush();
  text.replace(text.rfind("</robot>"), 8, R"(<fp:stop name="bump_left" parent="top_coil_left" child="foot_coil_left">
  <bump gap="45 mm" stiffness="100 N/mm"/></fp:stop></robot>)");
  const AxleKinematics kinematics = KinematicsOfAxle(text, {});
  EXPECT_NEAR(TravelNamed(kinematics, "heave").upper, 0.045, kSame);
  EXPECT_NEAR(TravelNamed(kinematics, "heave").lower, -kUsualTravel, kSame);
}

}  // namespace
}  // namespace fourpost::axle_kinematics_test
