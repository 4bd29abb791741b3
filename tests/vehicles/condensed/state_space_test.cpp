#include "vehicles/condensed/state_space.h"

#include <complex>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/vehicles/quarter_cars.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/linear_response.h"

namespace fourpost::state_space_test {
namespace {

CondensedModel Model(const Vehicle& vehicle) { return CondensedVehicle(vehicle).At(vehicle.ParameterValues()); }

// c (i w - a)^-1 b + d ... against the response from impedances; with damping in the tyres, which velocities go
// through.
TEST(StateSpace, HasTheResponseOfItsVehicle) {
  Vehicle vehicle = Describe(SeriesCar());
  vehicle.tyres[0].damping = {300};
  const CondensedModel model = Model(vehicle);
  const StateSpace space(model);
  for (const double f : {0.5, 1.4, 5.0, 16.0, 30.0}) {
    const std::complex<double> s(0, 2 * M_PI * f);
    const Eigen::MatrixXcd states = s * Eigen::MatrixXcd::Identity(space.a.rows(), space.a.rows()) - space.a;
    const Eigen::MatrixXcd response = space.c * states.lu().solve(space.b.cast<std::complex<double>>()).eval() +
                                      space.d + s * space.d_rate + s * s * space.d_acceleration;
    const Eigen::MatrixXcd expected = LinearResponse(model, f);
    // Rounding.
    EXPECT_LT((response - expected).norm(), 1e-9 * expected.norm()) << f;
  }
}

// The wheel's height after an impulse of the ground: z_u'' = kt / m_u at first (thesis 4.6).
TEST(StateSpace, StartsWithWhatAnImpulseGives) {
  const QuarterCar car = ThesisCar();
  const Vehicle vehicle = Describe(car);
  Eigen::Index wheel = -1;
  for (std::size_t i = 0; i < vehicle.sensors.size(); ++i)
    if (vehicle.sensors[i].name == "z_unsprung") wheel = static_cast<Eigen::Index>(i);
  ASSERT_GE(wheel, 0);
  constexpr double kStep = 1e-6;
  const Eigen::MatrixXd readings = StateSpace(Model(vehicle)).ImpulseResponse(Eigen::VectorXd::Ones(1), kStep, 2);
  EXPECT_NEAR(readings(0, wheel), 0, 1e-12);
  // A step of a microsecond against a period of 60 ms.
  EXPECT_NEAR((readings(1, wheel) - readings(0, wheel)) / kStep, car.tyre_stiffness / car.unsprung_mass,
              1e-3 * car.tyre_stiffness / car.unsprung_mass);
}

}  // namespace
}  // namespace fourpost::state_space_test
