// What `fourpost kinematics` says of cars from hard points, against equations of the points alone.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/vehicles/poses/newton_solver.h"
#include "tests/vehicles/templates/suspension_cars.h"
#include "vehicles/poses/axle_kinematics.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::suspension_kinematics_test {
namespace {

using newton::Place;
using newton::Vec;
using suspension_cars::KindsOf;
using suspension_cars::VehicleOf;
using suspension_cars::WithoutBars;

/// Points stand in the file to a nanometre, some decimetres apart; and what the solvers leave.
constexpr double kDigits = 3e-8;

/// The rear axle's points, by name.
struct RearPoints {
  std::vector<HardPoint> all;
  Vec operator()(std::string_view name) const {
    for (const HardPoint& point : all)
      if (point.axle == "rear" && point.name == name) return point.xyz;
    throw std::out_of_range(std::string(name));
  }
};

Vec MirrorOf(const Vec& p) { return {p.x(), -p.y(), p.z()}; }

Eigen::VectorXd Column(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Heave of the rear axle of a car whose rear has this kind, by 10 mm.
struct RearHeave {
  RearPoints points;
  AxleTravel travel;
  std::vector<double> loads;

  explicit RearHeave(std::string_view kind, const std::string& changed = "", double value = 0) {
    const auto kinds = KindsOf("double_wishbone", kind);
    points.all = WithoutBars(UsualPoints(kinds));
    const Vehicle vehicle = VehicleOf(kinds, points.all);
    std::vector<double> values = vehicle.ParameterValues();
    for (std::size_t i = 0; i < values.size(); ++i)
      if (vehicle.parameters[i].name == changed) values[i] = value;
    SuspensionRig rig(vehicle, values);
    for (const AxleKinematics& axle : KinematicsOf(rig, values, {-0.05, 0.05, 0.01}))
      if (rig.suspension().axles[axle.axle].name == "rear") travel = axle.travels.at(0);
    EXPECT_EQ(travel.stations.size(), 11u);
  }
};

/// The left wheel's axis stands across in the design pose.
void ExpectWheel(const RearHeave& heave, const std::function<Place(double rise)>& place_at) {
  const Vec centre = heave.points("wheel_centre");
  for (const AxleStation& station : heave.travel.stations) {
    SCOPED_TRACE(station.travel);
    const Place place = place_at(station.travel);
    const Vec axis = place.Rotation().col(1);
    const WheelPlace& left = station.wheels.at(0).place;
    EXPECT_NEAR(left.camber, -std::asin(axis.z()), kDigits);
    EXPECT_NEAR(left.toe, std::atan2(axis.x(), axis.y()), kDigits);
    EXPECT_NEAR((left.centre - place(centre)).norm(), 0, kDigits);
  }
}

TEST(SuspensionKinematics, DoubleWishbone) {
  const RearHeave heave("double_wishbone");
  const RearPoints& p = heave.points;
  ExpectWheel(heave, [&](double rise) {
    return newton::Solve([&](const Place& at) {
      return Column(
          {newton::Rod(at, p("lower_front"), p("lower_ball")), newton::Rod(at, p("lower_rear"), p("lower_ball")),
           newton::Rod(at, p("upper_front"), p("upper_ball")), newton::Rod(at, p("upper_rear"), p("upper_ball")),
           newton::Rod(at, p("tie_inner"), p("tie_outer")), at(p("wheel_centre")).z() - p("wheel_centre").z() - rise});
    });
  });
  // The axle is one that cambers and steers.
  EXPECT_GT(std::abs(heave.travel.stations.back().wheels[0].place.camber), 0.01);
  EXPECT_GT(std::abs(heave.travel.stations.back().wheels[0].place.toe), 1e-3);
}

TEST(SuspensionKinematics, MacPherson) {
  const RearHeave heave("macpherson");
  const RearPoints& p = heave.points;
  ExpectWheel(heave, [&](double rise) {
    return newton::Solve([&](const Place& at) {
      // The top mount stays on the strut's line.
      const Vec along = (at(p("strut_top")) - at(p("strut_bottom"))).normalized();
      const Vec aside = (p("strut_top") - at(p("strut_bottom"))).cross(along);
      return Column({newton::Rod(at, p("lower_front"), p("lower_ball")),
                     newton::Rod(at, p("lower_rear"), p("lower_ball")), newton::Rod(at, p("tie_inner"), p("tie_outer")),
                     aside.x(), aside.y(), at(p("wheel_centre")).z() - p("wheel_centre").z() - rise});
    });
  });
}

TEST(SuspensionKinematics, FiveLinks) {
  const RearHeave heave("multilink");
  const RearPoints& p = heave.points;
  ExpectWheel(heave, [&](double rise) {
    return newton::Solve([&](const Place& at) {
      std::vector<double> errors = {at(p("wheel_centre")).z() - p("wheel_centre").z() - rise};
      for (const std::string link : {"lower_front", "lower_rear", "upper_front", "upper_rear", "tie"})
        errors.push_back(newton::Rod(at, p(link + "_inner"), p(link + "_outer")));
      return Column(errors);
    });
  });
}

// The axis lies straight across: the wheel's centre goes round it in a circle, and neither cambers nor steers.
TEST(SuspensionKinematics, TrailingArmInClosedForm) {
  const RearHeave heave("trailing_arm");
  const Vec arm = heave.points("wheel_centre") - heave.points("pivot_inner");
  const double radius = std::hypot(arm.x(), arm.z());
  for (const AxleStation& station : heave.travel.stations) {
    const WheelPlace& left = station.wheels.at(0).place;
    const double x =
        heave.points("pivot_inner").x() - std::sqrt(radius * radius - std::pow(arm.z() + station.travel, 2));
    EXPECT_NEAR(left.centre.x(), x, kDigits);
    EXPECT_NEAR(left.camber, 0, kDigits);
    EXPECT_NEAR(left.toe, 0, kDigits);
  }
}

// Turned about its axis by the angle at which the centre has risen, by Rodrigues' formula.
TEST(SuspensionKinematics, SemiTrailingArm) {
  const RearHeave heave("semi_trailing_arm");
  const RearPoints& p = heave.points;
  const Vec axis = (p("pivot_outer") - p("pivot_inner")).normalized();
  ExpectWheel(heave, [&](double rise) {
    const auto turned = [&](double angle) {
      Place place{Vec::Zero(), angle * axis};
      place.shift = p("pivot_inner") - place.Rotation() * p("pivot_inner");
      return place;
    };
    const auto height = [&](double angle) {
      return turned(angle)(p("wheel_centre")).z() - p("wheel_centre").z() - rise;
    };
    double angle = 0;
    for (int i = 0; i < 50; ++i) angle -= height(angle) * 2e-6 / (height(angle + 1e-6) - height(angle - 1e-6));
    return turned(angle);
  });
}

/// Both wheels' rises, both lower links.
std::vector<double> LowerLinkErrors(const RearPoints& p, const Place& at, double rise) {
  const Vec centre = p("wheel_centre");
  return {at(centre).z() - centre.z() - rise, at(MirrorOf(centre)).z() - centre.z() - rise,
          newton::Rod(at, p("lower_body"), p("lower_axle")),
          newton::Rod(at, MirrorOf(p("lower_body")), MirrorOf(p("lower_axle")))};
}

TEST(SuspensionKinematics, ThreeLinksAndAPanhardRod) {
  const RearHeave heave("three_link_panhard");
  const RearPoints& p = heave.points;
  ExpectWheel(heave, [&](double rise) {
    return newton::Solve([&](const Place& at) {
      std::vector<double> errors = LowerLinkErrors(p, at, rise);
      errors.push_back(newton::Rod(at, p("upper_body"), p("upper_axle")));
      errors.push_back(newton::Rod(at, p("panhard_body"), p("panhard_axle")));
      return Column(errors);
    });
  });
  // The rod's end goes round its other one in a circle and takes the axle along, but for the axle's turns.
  const Vec rod = p("panhard_axle") - p("panhard_body");
  const double length = std::hypot(rod.y(), rod.z());
  const AxleStation& low = heave.travel.stations.front();
  const double aside = std::sqrt(length * length - std::pow(rod.z() + low.travel, 2)) - rod.y();
  EXPECT_NEAR(low.wheels[0].place.centre.y() - p("wheel_centre").y(), aside, 0.1 * std::abs(aside));
}

TEST(SuspensionKinematics, FourConvergingLinks) {
  const RearHeave heave("four_link");
  const RearPoints& p = heave.points;
  ExpectWheel(heave, [&](double rise) {
    return newton::Solve([&](const Place& at) {
      std::vector<double> errors = LowerLinkErrors(p, at, rise);
      errors.push_back(newton::Rod(at, p("upper_body"), p("upper_axle")));
      errors.push_back(newton::Rod(at, MirrorOf(p("upper_body")), MirrorOf(p("upper_axle"))));
      return Column(errors);
    });
  });
}

TEST(SuspensionKinematics, AFrame) {
  const RearHeave heave("a_frame");
  const RearPoints& p = heave.points;
  const Vec hinge(p("frame_body").x(), 0, p("frame_body").z());
  ExpectWheel(heave, [&](double rise) {
    return newton::Solve([&](const Place& at) {
      std::vector<double> errors = LowerLinkErrors(p, at, rise);
      errors.push_back(at(p("frame_ball")).y());
      errors.push_back(newton::Rod(at, hinge, p("frame_ball")));
      return Column(errors);
    });
  });
}

// One constraint too many, so the upper links yield: of all places that five constraints allow it is the one of least
// energy, of both links and both coils. Here the bushes have no rate against turning.
TEST(SuspensionKinematics, FourLinksAndAPanhardRodAtLeastEnergy) {
  const RearHeave heave("four_link_panhard", "kr_rear_link");
  const RearPoints& p = heave.points;
  const auto kinds = KindsOf("double_wishbone", "four_link_panhard");
  const Vehicle vehicle = VehicleOf(kinds, p.all);
  const std::vector<double> values = vehicle.ParameterValues();
  const auto value = [&](const std::string& name) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (vehicle.parameters[i].name == name) return values[i];
    throw std::out_of_range(name);
  };
  double tension = 0;
  const VehicleSummary summary = Summarise(vehicle, values);
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i)
    if (vehicle.springs[i].name == "rear_coil_left") tension = summary.spring_tension[i];
  const double link_rate = value("k_rear_link");
  const double coil_rate = value("k_rear");
  const auto energy = [&](const Place& at) {
    double sum = 0;
    for (const bool is_right : {false, true}) {
      const auto side = [&](const Vec& v) { return is_right ? MirrorOf(v) : v; };
      const double link = newton::Rod(at, side(p("upper_body")), side(p("upper_axle")));
      const double coil = newton::Rod(at, side(p("spring_top")), side(p("spring_bottom")));
      sum += 0.5 * link_rate * link * link + tension * coil + 0.5 * coil_rate * coil * coil;
    }
    return sum;
  };
  const auto place = [&](double rise) {
    const auto constraints = [&](const Place& at) {
      std::vector<double> errors = LowerLinkErrors(p, at, rise);
      errors.push_back(newton::Rod(at, p("panhard_body"), p("panhard_axle")));
      return Column(errors);
    };
    const auto moved = [](const Place& at, const Eigen::VectorXd& step) {
      return Place{at.shift + step.head<3>(), at.turn + step.tail<3>()};
    };
    return newton::Solve([&](const Place& at) {
      Eigen::MatrixXd jacobian(5, 6);
      Eigen::VectorXd slope(6);
      for (int i = 0; i < 6; ++i) {
        const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(6, i);
        jacobian.col(i) = (constraints(moved(at, step)) - constraints(moved(at, -step))) / 2e-5;
        slope[i] = (energy(moved(at, step)) - energy(moved(at, -step))) / 2e-5;
      }
      const Eigen::VectorXd free = jacobian.fullPivLu().kernel().col(0);
      Eigen::VectorXd errors(6);
      errors << constraints(at), 1e-6 * slope.dot(free) / free[4];
      return errors;
    });
  };
  for (const AxleStation& station : heave.travel.stations) {
    SCOPED_TRACE(station.travel);
    const Place at = place(station.travel);
    const Vec centre = p("wheel_centre");
    // Differences of energies, and what the links' own weights turn: micrometres.
    EXPECT_NEAR((station.wheels.at(0).place.centre - at(centre)).norm(), 0, 1e-6);
    EXPECT_NEAR((station.wheels.at(1).place.centre - at(MirrorOf(centre))).norm(), 0, 1e-6);
  }
}

// Bushes yield a little where arms are held by them: a tenth of a millimetre of the circle about the pivots.
TEST(SuspensionKinematics, TwistBeamTurnsAboutItsBushesInHeave) {
  const RearHeave heave("twist_beam");
  const Vec arm = heave.points("wheel_centre") - heave.points("pivot");
  const double radius = std::hypot(arm.x(), arm.z());
  for (const AxleStation& station : heave.travel.stations) {
    const WheelPlace& left = station.wheels.at(0).place;
    const double x = heave.points("pivot").x() - std::sqrt(radius * radius - std::pow(arm.z() + station.travel, 2));
    EXPECT_NEAR(left.centre.x(), x, 5e-4);
    EXPECT_NEAR(left.camber, 0, 1e-6);
  }
}

// Three quarters of the front half's length, of leaves that do not wind up: the axle stays upright.
TEST(SuspensionKinematics, LeafSpringMovesAboutThreeQuartersOfItsFrontHalf) {
  const RearHeave heave("leaf_spring", "kr_rear_windup", 1e12);
  const Vec arm = 0.75 * (heave.points("front_eye") - heave.points("seat"));
  for (const AxleStation& station : heave.travel.stations) {
    const double along = std::sqrt(arm.squaredNorm() - std::pow(arm.z() - station.travel, 2));
    EXPECT_NEAR(station.wheels.at(0).place.centre.x() - heave.points("wheel_centre").x(), arm.x() - along, kDigits);
  }
}

}  // namespace
}  // namespace fourpost::suspension_kinematics_test
