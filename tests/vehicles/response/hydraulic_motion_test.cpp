// A hydraulic damper at work in the multibody, against its own equations.
#include <algorithm>
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/resting.h"
#include "tests/vehicles/vehicle_parts.h"

namespace fourpost::hydraulic_motion_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// 200 kg on a coil and a hydraulic damper, which may move up and down.
const std::string kOnOil = R"(<robot name="on_oil" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
)" + PointMass("body", "200") +
                           PrismaticJoint("heave", "ground", "body", "0 0 0.5") +
                           R"(
  <fp:spring name="coil" parent="body" child="ground"><linear stiffness="20 N/mm"/></fp:spring>
  <fp:damper name="oil" parent="body" child="ground">
    <hydraulic bleed="0.6 mm^2" rebound_valve="10 MPa*s/kg" bulk_modulus="100 MPa"/>
    <friction force="30 N" speed="20 mm/s"/>
  </fp:damper>
</robot>
)";

/// Position, velocity and pressures, and their rates by the damper's own equations.
std::array<double, 4> Rates(const HydraulicDamper& damper, const std::array<double, 4>& y) {
  const std::array<double, 2> pressures = {y[2], y[3]};
  const std::array<double, 2> rates = damper.PressureRates(y[0], y[1], pressures);
  return {y[1], (-20e3 * y[0] - damper.Force(y[1], pressures)) / 200, rates[0], rates[1]};
}

// Let go 40 mm above its rest: the multibody against Runge and Kutta's fourth order with steps of 5 us.
TEST(HydraulicDamper, MovesABodyByItsOwnEquations) {
  const Vehicle vehicle = VehicleOf(kOnOil);
  const HydraulicDamper damper = vehicle.dampers[0].HydraulicAt({});
  Multibody multibody = Resting(vehicle);
  VectorXd state = multibody.RestState();
  state[0] = 0.04;
  std::array<double, 4> y = {0.04, 0, damper.gas_pressure, damper.gas_pressure};
  constexpr double kStep = 5e-6;
  constexpr int kStepsPerSample = 1000;
  int samples = 0;
  double lowest = 0;
  multibody.Integrate(
      state, 0, kStep * kStepsPerSample, 1e-9,
      [&](double, const VectorXd& now, const VectorXd&) {
        // 1e-9 of about 1 (m, m/s, MPa), once per some hundred steps.
        for (Index i = 0; i < 2; ++i) EXPECT_NEAR(now[i], y[static_cast<std::size_t>(i)], 1e-7);
        for (Index i = 2; i < 4; ++i)
          EXPECT_NEAR(now[i], (y[static_cast<std::size_t>(i)] - damper.gas_pressure) / 1e6, 1e-6);
        lowest = std::min(lowest, now[2]);
        const auto along = [&](double h, const std::array<double, 4>& rates) {
          std::array<double, 4> moved = y;
          for (std::size_t i = 0; i < 4; ++i) moved[i] += h * rates[i];
          return moved;
        };
        for (int k = 0; k < kStepsPerSample; ++k) {
          const auto k1 = Rates(damper, y);
          const auto k2 = Rates(damper, along(kStep / 2, k1));
          const auto k3 = Rates(damper, along(kStep / 2, k2));
          const auto k4 = Rates(damper, along(kStep, k3));
          for (std::size_t i = 0; i < 4; ++i) y[i] += kStep / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
        ++samples;
      },
      [&] { return samples > 100; });
  EXPECT_LT(lowest, -0.1) << "the oil was not pressed";
}

}  // namespace
}  // namespace fourpost::hydraulic_motion_test
