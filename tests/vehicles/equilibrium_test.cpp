#include "vehicles/equilibrium.h"

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed_vehicle.h"
#include "vehicles/harmonic_balance.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::HasSubstr;
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
  EXPECT_EQ(Fault(vehicle), "");
  EXPECT_NEAR(CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues()).tyre[0], kTyreLoad, 1e-9);  // rounding
}

TEST(Equilibrium, NeedsNoSpringWhereNothingHasWeight) {
  Vehicle vehicle = QuarterCarWith({}, {});
  vehicle.springs.clear();
  vehicle.tyres.clear();
  vehicle.posts.clear();
  vehicle.sensors.pop_back();
  for (Joint& joint : vehicle.joints) joint.axis = Eigen::Vector3d::UnitX();
  EXPECT_EQ(Fault(vehicle), "");
}

TEST(Equilibrium, NamesEachLinkThatNothingHolds) {
  Vehicle vehicle = QuarterCarWith({}, {});
  vehicle.springs.clear();
  vehicle.tyres.clear();
  vehicle.posts.clear();
  vehicle.sensors.pop_back();
  EXPECT_THAT(Fault(vehicle), AllOf(HasSubstr("can hold the weight of link 'sprung'"),
                                    HasSubstr("can hold the weight of link 'unsprung'")));
}

TEST(Equilibrium, NamesAPreloadThatNothingBalances) {
  const Vehicle vehicle = QuarterCarWith({}, 2000);
  EXPECT_EQ(Fault(vehicle),
            vehicle.file + ":" + std::to_string(vehicle.tyres[0].source_line) +
                ": error: no static equilibrium: the preload of fp:tyre 'tyre', 2000 N, is not balanced; correct it or "
                "write preload=\"equilibrium\"");
}

TEST(Equilibrium, NamesAllPreloadsWhenAllAreGivenAndOneIsWrong) {
  const std::string fault = Fault(QuarterCarWith(kSpringTension, 2000));
  EXPECT_THAT(fault, AllOf(HasSubstr("fp:spring 'spring', -1961.33 N"), HasSubstr("fp:tyre 'tyre', 2000 N")));
}

TEST(Equilibrium, TakesAPreloadOfSevenDigitsButNotOfFour) {
  EXPECT_EQ(Fault(QuarterCarWith(kSpringTension, 2177.076)), "");
  EXPECT_THAT(Fault(QuarterCarWith(kSpringTension, 2177)), HasSubstr("fp:tyre 'tyre', 2177 N, is not balanced"));
}

// Balanced at 200 kg only.
TEST(Equilibrium, NamesAFreeMassThatNoPreloadFollows) {
  Vehicle vehicle = QuarterCarWith(kSpringTension, kTyreLoad);
  vehicle.parameters[0].lower = 100;
  const std::string fault = Fault(vehicle);
  EXPECT_THAT(fault, HasSubstr(":" + std::to_string(vehicle.parameters[0].line) +
                               ": error: no static equilibrium but at one value of fp:parameter 'm_sprung': the weight "
                               "of link 'sprung' follows it"));
  EXPECT_THAT(fault, Not(HasSubstr("unsprung")));
}

TEST(Equilibrium, NamesAFreePreloadThatNoOtherFollows) {
  Vehicle vehicle = QuarterCarWith({}, {});
  const int index = static_cast<int>(vehicle.parameters.size());
  vehicle.parameters.push_back({.name = "load", .value = kTyreLoad, .lower = 2000, .upper = 2500, .precision = 1});
  vehicle.tyres[0].preload = Scalar{.value = kTyreLoad, .parameter = index};
  EXPECT_THAT(Fault(vehicle), HasSubstr("fp:parameter 'load': the preload of fp:tyre 'tyre' follows it"));
}

TEST(Equilibrium, FollowsAFreePreloadThatAnotherMakesUpFor) {
  Vehicle vehicle = QuarterCarWith({}, {});
  const int index = static_cast<int>(vehicle.parameters.size());
  vehicle.parameters.push_back({.name = "helper", .value = 300, .lower = 200, .upper = 500, .precision = 1});
  Spring helper = vehicle.springs[0];
  helper.element = "fp:spring 'helper'";
  helper.preload = Scalar{.value = 300, .parameter = index};
  vehicle.springs.push_back(helper);
  EXPECT_EQ(Fault(vehicle), "");
  std::vector<double> values = vehicle.ParameterValues();
  values.back() = 500;
  EXPECT_NEAR(CondensedVehicle(vehicle).PreloadsAt(values).spring[0], kSpringTension - 500, 1e-9);  // rounding
}

// A beam over one pivot: neither end is held, but each balances the other.
TEST(Equilibrium, LetsLinksBalanceEachOther) {
  const auto end = [](const char* name, double kilogram, double lever) {
    return GivenForce{.element = name, .size = kilogram, .direction = Eigen::VectorXd::Constant(1, lever)};
  };
  Diagnostics faults;
  CheckEquilibrium({}, {end("link 'left'", 10, 9), end("link 'right'", 30, -3)}, Eigen::MatrixXd(1, 0), faults);
  EXPECT_EQ(faults.Format(), "");
  CheckEquilibrium({}, {end("link 'left'", 10, 9), end("link 'right'", 31, -3)}, Eigen::MatrixXd(1, 0), faults);
  EXPECT_THAT(faults.Format(), HasSubstr("link 'right'"));
}

TEST(Equilibrium, SharesAlikeWhatIsIndeterminate) {
  // Two equal springs under one mass.
  const Eigen::MatrixXd map = PreloadMap(Eigen::MatrixXd::Constant(1, 2, 1));
  const Eigen::VectorXd preloads = map * Eigen::VectorXd::Constant(1, 100);
  EXPECT_NEAR(preloads[0], -50, 1e-13);  // rounding
  EXPECT_NEAR(preloads[1], -50, 1e-13);
}

}  // namespace
}  // namespace fourpost
