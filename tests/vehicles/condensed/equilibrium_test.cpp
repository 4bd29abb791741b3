#include "vehicles/condensed/equilibrium.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <string>

#include <gmock/gmock.h>

#include "analysis/text/units.h"
#include "tests/findings.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/findings.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::equilibrium_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

// Weights of the quarter car, 200 kg on 22 kg.
constexpr double kSpringTension = -1961.33;
constexpr double kTyreLoad = 2177.0763;

void Fix(Vehicle& vehicle) {
  for (Parameter& parameter : vehicle.parameters) {
    parameter.lower = parameter.upper = parameter.value;
    parameter.precision = 0;
  }
}

/// The quarter car with these preloads and parameters that stay as they are.
Vehicle QuarterCarWith(std::optional<double> tension, std::optional<double> load) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Fix(vehicle);
  if (tension) vehicle.springs[0].preload = Scalar{*tension};
  if (load) vehicle.tyres[0].preload = Scalar{*load};
  return vehicle;
}

int LinkLine(const Vehicle& vehicle, const std::string& name) {
  return std::find_if(vehicle.links.begin(), vehicle.links.end(), [&](const Link& link) { return link.name == name; })
      ->line;
}

TEST(Equilibrium, MayHaveEveryPreloadGiven) {
  const Vehicle given = QuarterCarWith(kSpringTension, kTyreLoad);
  const Vehicle found = QuarterCarWith({}, {});
  const CondensedModel a = CondensedVehicle(given).At(given.ParameterValues());
  const CondensedModel b = CondensedVehicle(found).At(found.ParameterValues());
  EXPECT_EQ(a.preloads.spring[0], kSpringTension);
  // Vertical coordinates have no curvature: preloads do not matter. Differences leave 1e-12 per metre of 2 kN.
  EXPECT_LT((a.stiffness - b.stiffness).norm(), 1e-8);
}

TEST(Equilibrium, MayHaveOnePreloadGiven) {
  const Vehicle vehicle = QuarterCarWith(kSpringTension, {});
  EXPECT_THAT(Fault(vehicle).items(), IsEmpty());
  EXPECT_NEAR(CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues()).tyre[0], kTyreLoad, 1e-9);  // rounding
}

// Chords of 40 and 20 kN/m meet with the slope 30 kN/m, beside a spring of 20 kN/m.
TEST(Equilibrium, SharesALoadByTheRateOfAMeasuredSpringInTheDesignPose) {
  Vehicle vehicle = QuarterCarWith({}, {});
  vehicle.springs.push_back(vehicle.springs[0]);
  vehicle.springs[0].law = {.stiffness = {},
                            .cubic = {},
                            .knees = {},
                            .table = {{{-0.1}, {-3000}}, {{-0.05}, {-1000}}, {{0}, {0}}},
                            .place = {-0.05}};
  vehicle.springs[1].law = {.stiffness = {20e3}, .cubic = {}, .knees = {}};
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues());
  EXPECT_NEAR(preloads.spring[0], 0.6 * kSpringTension, 1e-9);  // rounding
  EXPECT_NEAR(preloads.spring[1], 0.4 * kSpringTension, 1e-9);
}

TEST(Equilibrium, NeedsNoSpringWhereNothingHasWeight) {
  Vehicle vehicle = QuarterCarWith({}, {});
  vehicle.springs.clear();
  vehicle.tyres.clear();
  vehicle.posts.clear();
  vehicle.sensors.pop_back();
  for (Joint& joint : vehicle.joints) joint.axis = Eigen::Vector3d::UnitX();
  EXPECT_THAT(Fault(vehicle).items(), IsEmpty());
}

TEST(Equilibrium, NamesEachMotionThatNothingHolds) {
  Vehicle vehicle = QuarterCarWith({}, {});
  vehicle.springs.clear();
  vehicle.dampers.clear();
  vehicle.tyres.clear();
  vehicle.posts.clear();
  vehicle.sensors.pop_back();
  EXPECT_THAT(Fault(vehicle), AllOf(Reports(kUnheld, vehicle.links[1].line, {"heave of link 'unsprung'"}),
                                    Reports(kUnheld, vehicle.links[2].line, {"heave of link 'sprung'"})));
}

TEST(Equilibrium, NamesADamperWithoutASpringBesideIt) {
  Vehicle vehicle = QuarterCarWith({}, {});
  vehicle.springs.clear();
  EXPECT_THAT(Fault(vehicle),
              ReportsOnly(kUnheldDamper, vehicle.links[2].line, {"heave of link 'sprung'", "fp:damper 'damper'"}));
}

TEST(Equilibrium, DoesNotTakeGasForASpring) {
  Vehicle vehicle = QuarterCarWith({}, {});
  vehicle.springs[0].kind = Spring::Kind::kGas;
  vehicle.springs[0].name = "damper";
  vehicle.springs[0].preload = Scalar{-120};
  EXPECT_THAT(Fault(vehicle), Reports(kUnheldDamper, {"heave of link 'sprung'"}));
}

TEST(Equilibrium, NamesABushingThatCouldHold) {
  Vehicle vehicle = QuarterCarWith({}, {});
  const ForceLine line = vehicle.springs[0].line;
  vehicle.springs.clear();
  vehicle.bushings.push_back({.name = "mount", .parent = line.parent, .child = line.child});
  vehicle.bushings[0].stiffness[2].value = 1e5;
  EXPECT_THAT(Fault(vehicle),
              ReportsOnly(kUnheldBushing, vehicle.links[2].line, {"heave of link 'sprung'", "fp:bushing 'mount'"}));
}

// Without track rods the uprights steer under the weight on inclined axes; all other bodies follow by a little.
TEST(Equilibrium, NamesBothSidesOfASteeringThatNothingHoldsOnce) {
  Vehicle vehicle = ShippedVehicle("independent_roadster");
  vehicle.rods.clear();
  EXPECT_THAT(Fault(vehicle), ReportsOnly(kUnheld, LinkLine(vehicle, "front_upright_left"),
                                          {"yaw of link 'front_upright_left' and link 'front_upright_right'"}));
}

// The upper arms hang free, and the body sinks while the uprights lean.
TEST(Equilibrium, NamesWhatMovesWithoutUpperBallJoints) {
  Vehicle vehicle = ShippedVehicle("independent_roadster");
  std::erase_if(vehicle.balls, [](const Ball& ball) { return ball.name.starts_with("front_upper"); });
  const Diagnostics fault = Fault(vehicle);
  EXPECT_THAT(fault, Reports(kUnheld, LinkLine(vehicle, "front_upper_left"),
                             {"heave of link 'front_upper_left' and link 'front_upper_right'"}));
  EXPECT_THAT(fault,
              Reports(kUnheld, {"heave of link 'body'", "link 'front_upright_left'", "link 'front_upright_right'"}));
  EXPECT_EQ(fault.items().size(), 2u);
}

TEST(Equilibrium, NamesWhereCoilsAreMissingAndNotTheStops) {
  Vehicle vehicle = ShippedVehicle("independent_roadster");
  std::erase_if(vehicle.springs, [](const Spring& spring) {
    return spring.kind == Spring::Kind::kCoil && spring.name.starts_with("front");
  });
  EXPECT_THAT(Fault(vehicle),
              ReportsOnly(kUnheldDamper, LinkLine(vehicle, "body"),
                          {"heave of link 'body'", "link 'front_upper_left' and link 'front_upper_right'",
                           "fp:damper 'front_left' and fp:damper 'front_right'"}));
  std::erase_if(vehicle.dampers, [](const Damper& damper) { return damper.name.starts_with("front"); });
  EXPECT_THAT(Fault(vehicle), Reports(kUnheldStop, {"fp:stop 'front_left' and fp:stop 'front_right'"}));
}

TEST(Equilibrium, NamesAPreloadThatNothingBalances) {
  const Vehicle vehicle = QuarterCarWith({}, 2000);
  EXPECT_THAT(Fault(vehicle), ReportsOnly(kPreloadUnbalanced, vehicle.tyres[0].source_line,
                                          {"fp:tyre 'tyre'", "2000 N", "2177.076 N"}));
}

// One line sets both: told once, with the size that both need.
TEST(Equilibrium, TellsThePreloadThatTwinsNeedTogether) {
  Vehicle vehicle = ShippedVehicle("independent_roadster");
  Fix(vehicle);
  const Preloads needed = CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues());
  std::vector<double> tensions;
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    Spring& spring = vehicle.springs[i];
    if (spring.kind != Spring::Kind::kCoil || !spring.name.starts_with("rear_")) continue;
    spring.preload = Scalar{-2000};
    tensions.push_back(needed.spring[i]);
  }
  ASSERT_EQ(tensions.size(), 2U);
  const std::vector<Diagnostic> faults = Fault(vehicle).items();
  ASSERT_THAT(faults, ElementsAre(IsFinding(kPreloadUnbalanced, {"-2000 N"})));
  // The other force.
  std::smatch balanced;
  ASSERT_TRUE(std::regex_search(faults[0].message, balanced, std::regex("-2000 N.* (-[0-9.]+) N")));
  // Printed digits.
  EXPECT_NEAR(std::stod(balanced[1]), tensions[0], 1e-3);
  EXPECT_NEAR(tensions[0], tensions[1], 1e-6);
}

TEST(Equilibrium, NamesAllPreloadsWhenAllAreGivenAndOneIsWrong) {
  EXPECT_THAT(Fault(QuarterCarWith(kSpringTension, 2000)),
              AllOf(Reports(kPreloadUnbalanced, {"fp:spring 'spring'", "-1961.33 N"}),
                    Reports(kPreloadUnbalanced, {"fp:tyre 'tyre'", "2000 N"})));
}

TEST(Equilibrium, TakesAPreloadOfSevenDigitsButNotOfFour) {
  EXPECT_THAT(Fault(QuarterCarWith(kSpringTension, 2177.076)).items(), IsEmpty());
  EXPECT_THAT(Fault(QuarterCarWith(kSpringTension, 2177)), Reports(kPreloadUnbalanced, {"fp:tyre 'tyre'", "2177 N"}));
}

// Balanced at 200 kg only.
TEST(Equilibrium, NamesAFreeMassThatNoPreloadFollows) {
  Vehicle vehicle = QuarterCarWith(kSpringTension, kTyreLoad);
  vehicle.parameters[0].lower = 100;
  const Diagnostics fault = Fault(vehicle);
  EXPECT_THAT(fault, Reports(kEquilibriumAtOneValue, vehicle.parameters[0].line,
                             {"fp:parameter 'm_sprung'", "weight of link 'sprung'"}));
  EXPECT_THAT(fault, Not(Reports(kEquilibriumAtOneValue, {"unsprung"})));
}

TEST(Equilibrium, NamesAFreePreloadThatNoOtherFollows) {
  Vehicle vehicle = QuarterCarWith({}, {});
  const int index = static_cast<int>(vehicle.parameters.size());
  vehicle.parameters.push_back({.name = "load", .value = kTyreLoad, .lower = 2000, .upper = 2500, .precision = 1});
  vehicle.tyres[0].preload = Scalar{.value = kTyreLoad, .parameter = index};
  EXPECT_THAT(Fault(vehicle), Reports(kEquilibriumAtOneValue, {"fp:parameter 'load'", "preload of fp:tyre 'tyre'"}));
}

TEST(Equilibrium, FollowsAFreePreloadThatAnotherMakesUpFor) {
  Vehicle vehicle = QuarterCarWith({}, {});
  const int index = static_cast<int>(vehicle.parameters.size());
  vehicle.parameters.push_back({.name = "helper", .value = 300, .lower = 200, .upper = 500, .precision = 1});
  Spring helper = vehicle.springs[0];
  helper.name = "helper";
  helper.preload = Scalar{.value = 300, .parameter = index};
  vehicle.springs.push_back(helper);
  EXPECT_THAT(Fault(vehicle).items(), IsEmpty());
  std::vector<double> values = vehicle.ParameterValues();
  values.back() = 500;
  EXPECT_NEAR(CondensedVehicle(vehicle).PreloadsAt(values).spring[0], kSpringTension - 500, 1e-9);  // rounding
}

/// The quarter car with a spring beside its coil that is without load when 50 mm longer.
Vehicle WithHelper(const SpringDescription& law) {
  Vehicle vehicle = QuarterCarWith({}, {});
  Spring helper = vehicle.springs[0];
  helper.name = "helper";
  helper.law = law;
  helper.free_length = Scalar{DesignKinematics(vehicle).LineLength(helper.line).value + 0.05};
  vehicle.springs.push_back(helper);
  return vehicle;
}

TEST(Equilibrium, TakesAFreeLengthForThatOfTheWholeLaw) {
  const SpringDescription linear{.stiffness = {10e3}, .cubic = {}, .knees = {}};
  SpringDescription full{.stiffness = {10e3}, .cubic = {1e6}, .knees = {}};
  full.knees.push_back({.side = 1, .at = {0.02}, .rate = {15e3}, .cubic = {}});
  const double cubic = 1e6 * 0.05 * 0.05 * 0.05;
  for (const auto& [law, tension] : {std::pair(linear, -500.0), std::pair(full, -500 - cubic - 5e3 * 0.03)}) {
    const Vehicle vehicle = WithHelper(law);
    EXPECT_THAT(Fault(vehicle).items(), IsEmpty());
    const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues());
    EXPECT_NEAR(preloads.spring[1], tension, 1e-9);  // rounding
    EXPECT_NEAR(preloads.spring[0], kSpringTension - tension, 1e-9);
  }
}

TEST(Equilibrium, TellsWhatAFreeLengthWouldHaveToMake) {
  Vehicle vehicle = WithHelper({.stiffness = {10e3}, .cubic = {}, .knees = {}});
  vehicle.springs.erase(vehicle.springs.begin());
  EXPECT_THAT(Fault(vehicle),
              Reports(kFreeLengthWrong, {"fp:spring 'helper'", "-500 N", "-1961.33 N", "free_length=\""}));
}

// No length would do: the next mass needs another one.
TEST(Equilibrium, SaysToRemoveAFreeLengthWhereTheLoadHasBounds) {
  Vehicle vehicle = WithHelper({.stiffness = {10e3}, .cubic = {}, .knees = {}});
  vehicle.springs.erase(vehicle.springs.begin());
  Link& body = vehicle.links[static_cast<std::size_t>(vehicle.joints.back().child)];
  const int index = static_cast<int>(vehicle.parameters.size());
  const double mass = body.mass.value;
  vehicle.parameters.push_back({.name = "m_body", .value = mass, .lower = mass, .upper = 2 * mass, .precision = 1});
  body.mass = Scalar{.value = mass, .parameter = index};
  EXPECT_THAT(Fault(vehicle), Reports(kFreeLengthFollows, {"fp:parameter 'm_body'"}));
}

// What it says to write is balanced, of a law that bends too.
TEST(Equilibrium, StatesTheFreeLengthThatIsBalanced) {
  SpringDescription full{.stiffness = {10e3}, .cubic = {1e6}, .knees = {}};
  full.knees.push_back({.side = 1, .at = {0.02}, .rate = {15e3}, .cubic = {}});
  for (const SpringDescription& law : {SpringDescription{.stiffness = {10e3}, .cubic = {}, .knees = {}}, full}) {
    Vehicle vehicle = WithHelper(law);
    vehicle.springs.erase(vehicle.springs.begin());
    const std::string fault = Fault(vehicle).Format();
    const std::string start = "free_length=\"";
    const std::size_t at = fault.find(start);
    ASSERT_NE(at, std::string::npos) << fault;
    const std::string length = fault.substr(at + start.size(), fault.find('"', at + start.size()) - at - start.size());
    const std::optional<Quantity> quantity = ParseQuantity(length);
    ASSERT_TRUE(quantity) << length;
    vehicle.springs[0].free_length = Scalar{quantity->si};
    EXPECT_THAT(Fault(vehicle).items(), IsEmpty());
  }
}

// The thesis's Model 3 with its body 50 mm to the left: each axle takes the roll moment by its stiffness, coils and
// tyres in series.
TEST(Equilibrium, TransfersLoadBetweenAxlesByRollStiffness) {
  Vehicle vehicle = ShippedVehicle("landrover110_model3");
  const CondensedVehicle condensed(vehicle);
  const auto loads = [&] { return condensed.PreloadsAt(vehicle.ParameterValues()).tyre; };
  for (const char* coil : {"k_FL", "k_FR"}) Set(vehicle, coil, 26e3);
  for (const char* coil : {"k_RL", "k_RR"}) Set(vehicle, coil, 80e3);
  const std::vector<double> middle = loads();
  Set(vehicle, "y_body", 0.05);
  const std::vector<double> aside = loads();
  const auto roll_compliance = [&](std::size_t left, double coil) {
    const double seat = vehicle.springs[left].line.child.xyz.y();
    const double track = vehicle.tyres[left].point.xyz.y();
    const double tyre = vehicle.tyres[left].law.stiffness.At(vehicle.ParameterValues());
    return 1 / (2 * coil * seat * seat) + 1 / (2 * tyre * track * track);
  };
  const double front = aside[0] - middle[0];
  const double rear = aside[2] - middle[2];
  EXPECT_NEAR(front, -(aside[1] - middle[1]), 1e-8);  // rounding of differences
  EXPECT_GT(front, 50);
  EXPECT_NEAR(rear / front, roll_compliance(0, 26e3) / roll_compliance(2, 80e3), 1e-10);
}

// A beam over one pivot: neither end is held, but each balances the other.
TEST(Equilibrium, LetsLinksBalanceEachOther) {
  const auto end = [](double kilogram, double lever) {
    return GivenForce{.size = kilogram, .direction = Eigen::VectorXd::Constant(1, lever)};
  };
  const auto fault = [&](double right) {
    Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(3, 1);
    turn(0, 0) = 1;
    const StaticLoads loads{.forces = {end(10, 9), end(right, -3)},
                            .holders = Eigen::MatrixXd(1, 0),
                            .links = {{.name = "beam",
                                       .mass = 10 + right,
                                       .inertia = Eigen::Vector3d::Ones(),
                                       .com_jacobian = Eigen::MatrixXd::Zero(3, 1),
                                       .spin_jacobian = turn}}};
    Diagnostics faults;
    CheckEquilibrium({}, loads, faults);
    return faults;
  };
  EXPECT_THAT(fault(30).items(), IsEmpty());
  EXPECT_THAT(fault(31), Reports(kUnheld, {"roll of link 'beam'"}));
}

// Two links that nothing holds, of which one carries weights that balance each other.
TEST(Equilibrium, LeavesOutWhatIsBalancedByItself) {
  const auto force = [](double kilogram, const Eigen::Vector2d& direction) {
    return GivenForce{.size = kilogram, .direction = direction};
  };
  const auto link = [](const char* name, const Eigen::RowVector2d& heave) {
    LinkMotion motion{.name = name,
                      .mass = 1,
                      .com_jacobian = Eigen::MatrixXd::Zero(3, 2),
                      .spin_jacobian = Eigen::MatrixXd::Zero(3, 2)};
    motion.com_jacobian.row(2) = heave;
    return motion;
  };
  const StaticLoads loads{.forces = {force(10, {9, 0}), force(30, {-3, 0}), force(5, {0, 9})},
                          .holders = Eigen::MatrixXd(2, 0),
                          .links = {link("beam", {1, 0}), link("stone", {0, 1})}};
  const std::vector<UnheldMotion> unheld = UnheldMotions(loads);
  ASSERT_EQ(unheld.size(), 1U);
  EXPECT_EQ(unheld[0].motion.Text(), "heave of link 'stone'");
}

}  // namespace
}  // namespace fourpost::equilibrium_test
