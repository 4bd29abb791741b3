#include "vehicles/condensed_vehicle.h"

#include <gmock/gmock.h>

#include "analysis/diagnostics.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/modes.h"
#include "vehicles/multibody.h"

namespace fourpost {
namespace {

using testing::HasSubstr;

/// The linkage car with linear dampers: its state derivative is smooth.
Vehicle SmoothCar() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  for (const char* name : {"c_front_bump", "c_front_rebound"}) Set(vehicle, name, 2200);
  for (const char* name : {"c_rear_bump", "c_rear_rebound"}) Set(vehicle, name, 2600);
  return vehicle;
}

/// Derivative of the multibody's state derivative at rest, by central differences.
Eigen::MatrixXd DifferencedStateMatrix(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  const Eigen::VectorXd rest = multibody.RestState();
  Eigen::MatrixXd matrix(rest.size(), rest.size());
  constexpr double kStep = 1e-5;
  for (Eigen::Index j = 0; j < rest.size(); ++j) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(rest.size(), j);
    matrix.col(j) =
        (multibody.StateDerivative(0, rest + step) - multibody.StateDerivative(0, rest - step)) / (2 * kStep);
  }
  return matrix;
}

void ExpectMultibodysStateMatrix(const Vehicle& vehicle) {
  const Eigen::MatrixXd condensed = StateMatrix(CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
  const Eigen::MatrixXd differenced = DifferencedStateMatrix(vehicle);
  ASSERT_EQ(condensed.rows(), differenced.rows());
  // Differences with a step h: truncation h^2 times third derivatives of order one, rounding eps times 1e3 m/s^2 over h.
  EXPECT_LT((condensed - differenced).cwiseAbs().maxCoeff(), 1e-7 * condensed.cwiseAbs().maxCoeff());
}

TEST(CondensedVehicle, HasTheStateMatrixOfTheMultibody) { ExpectMultibodysStateMatrix(SmoothCar()); }

TEST(CondensedVehicle, HasTheStateMatrixOfTheMultibodyWithASeriesDamper) {
  Vehicle vehicle = SmoothCar();
  vehicle.dampers[1].series_stiffness = Scalar{800e3};
  ExpectMultibodysStateMatrix(vehicle);
}

TEST(CondensedVehicle, HoldsTheDesignPoseAtRest) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const std::vector<double> values = vehicle.ParameterValues();
  Multibody multibody(vehicle);
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  // Rounding of some 10 kN on 200 kg.
  EXPECT_LT(multibody.StateDerivative(0, multibody.RestState()).norm(), 1e-9);
}

TEST(CondensedVehicle, TyresCarryTheWeight) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues());
  double mass = 0;
  for (const Link& link : vehicle.links) mass += link.mass.At(vehicle.ParameterValues());
  double load = 0;
  for (const double tyre : preloads.tyre) load += tyre;
  EXPECT_NEAR(load, mass * 9.80665, 1e-6);  // rounding of 20 kN
}

TEST(CondensedVehicle, FollowsParametersWithoutBeingBuiltAnew) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  Vehicle changed = vehicle;
  for (Parameter& parameter : changed.parameters) parameter.value = 0.5 * (parameter.lower + parameter.upper);
  const CondensedModel moved = CondensedVehicle(vehicle).At(changed.ParameterValues());
  const CondensedModel rebuilt = CondensedVehicle(changed).At(changed.ParameterValues());
  EXPECT_EQ(moved.mass, rebuilt.mass);
  EXPECT_EQ(moved.stiffness, rebuilt.stiffness);
  EXPECT_EQ(moved.preloads.tyre, rebuilt.preloads.tyre);
  EXPECT_NE(moved.stiffness, CondensedVehicle(vehicle).At(vehicle.ParameterValues()).stiffness);
}

TEST(CondensedVehicle, NamesALinkThatNothingHolds) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.springs.clear();
  try {
    const CondensedVehicle condensed(vehicle);
    FAIL() << "a car without a spring was held";
  } catch (const FaultyInput& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("can hold the weight of link 'sprung'"));
  }
}

}  // namespace
}  // namespace fourpost
