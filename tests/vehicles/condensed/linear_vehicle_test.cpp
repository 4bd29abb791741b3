#include "vehicles/condensed/linear_vehicle.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "tests/vehicles/element_car.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::linear_vehicle_test {
namespace {

CondensedModel ModelOf(const Vehicle& vehicle) { return CondensedVehicle(vehicle).At(vehicle.ParameterValues()); }

// The element car has dashpots with and without series springs.
TEST(LinearVehicle, IsSymmetric) {
  const LinearVehicle vehicle(ModelOf(ElementCar()), LinearVehicle::Rates::kCentre);
  EXPECT_GT(vehicle.series(), 0);
  for (const Eigen::MatrixXd* matrix : {&vehicle.mass, &vehicle.damping, &vehicle.stiffness})
    EXPECT_LT((*matrix - matrix->transpose()).cwiseAbs().maxCoeff(), 1e-12 * matrix->cwiseAbs().maxCoeff());
}

// States [s, iw s, x] that its forces move at w solve the state equations.
TEST(LinearVehicle, StatesAndImpedanceAgree) {
  const LinearVehicle vehicle(ModelOf(ElementCar()), LinearVehicle::Rates::kCentre);
  const Eigen::Index n = vehicle.mass.rows();
  const Eigen::VectorXd forces = Eigen::VectorXd::LinSpaced(vehicle.size(), 1, 2);
  for (const double omega : {3.0, 30.0, 300.0}) {
    const Eigen::VectorXcd motion = vehicle.Impedance(omega).partialPivLu().solve(forces.cast<std::complex<double>>());
    const std::complex<double> iw(0, omega);
    Eigen::VectorXcd states(2 * n + vehicle.series());
    states << motion.head(n), iw * motion.head(n), motion.tail(vehicle.series());
    const Eigen::VectorXcd rates = vehicle.StateMatrix() * states + vehicle.StateInput(forces);
    // Rounding of accelerations that are sums of larger ones.
    const double scale = (vehicle.StateMatrix().cwiseAbs() * states.cwiseAbs()).maxCoeff();
    EXPECT_LT((rates - iw * states).cwiseAbs().maxCoeff(), 1e-11 * scale) << omega;
  }
}

}  // namespace
}  // namespace fourpost::linear_vehicle_test
