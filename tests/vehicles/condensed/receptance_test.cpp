#include "vehicles/condensed/receptance.h"

#include <complex>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::receptance_test {
namespace {

using Complex = std::complex<double>;

/// Largest difference from a solution by factorisation, relative to the largest motion.
double DeviationBetween(const CondensedModel& model, const std::vector<double>& shape, double omega) {
  const std::vector<Port> ports = PortsOf(model);
  const Receptance receptance(model, ports, shape);
  EXPECT_TRUE(receptance.by_poles());
  const LinearVehicle vehicle(model, LinearVehicle::Rates::kCentre);
  const Eigen::Index n = model.mass.rows();
  const Eigen::VectorXcd tensions =
      Eigen::VectorXcd::LinSpaced(static_cast<Eigen::Index>(ports.size()), Complex(1, 2), Complex(-2, 1));
  const Eigen::Map<const Eigen::VectorXd> posts(shape.data(), static_cast<Eigen::Index>(shape.size()));
  Eigen::VectorXcd forces = Eigen::VectorXcd::Zero(vehicle.size());
  for (std::size_t j = 0; j < ports.size(); ++j) forces -= ports[j].direction * tensions[static_cast<Eigen::Index>(j)];
  forces.head(n) += 3.0 * (model.post_stiffness * posts + Complex(0, omega) * (model.post_damping * posts));
  const Eigen::VectorXcd expected = vehicle.Impedance(omega).partialPivLu().solve(forces);
  const Eigen::VectorXcd motion = receptance.Motion(omega, tensions, 3);
  return (motion - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

// Sums over poles keep what linear models promise.
TEST(Receptance, SolvesTheImpedance) {
  for (const char* name : {"landrover110_linkage", "landrover110_model3", "independent_roadster", "landrover110"}) {
    const Vehicle vehicle = ShippedVehicle(name);
    const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
    std::vector<double> shape(vehicle.posts.size(), 1);
    shape.back() = -0.5;
    for (const double omega : {0.0, 3.0, 30.0, 300.0, 3000.0})
      EXPECT_LT(DeviationBetween(model, shape, omega), 1e-9) << name << " at " << omega << " rad/s";
  }
}

TEST(Receptance, OfPortsIsTheirMotionPerTension) {
  const Vehicle vehicle = ElementCar();
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const std::vector<Port> ports = PortsOf(model);
  const auto count = static_cast<Eigen::Index>(ports.size());
  const Receptance receptance(model, ports, {1, 0.5, -0.3, 0.2});
  constexpr double kOmega = 9;
  Eigen::MatrixXcd all;
  receptance.Ports(kOmega, 3, all);
  for (int h = 0; h <= 3; ++h)
    for (Eigen::Index j = 0; j < count; ++j) {
      const Eigen::VectorXcd motion = receptance.Motion(h * kOmega, Eigen::VectorXcd::Unit(count, j), 0);
      for (Eigen::Index i = 0; i < count; ++i) {
        const Complex expected = ports[static_cast<std::size_t>(i)].direction.dot(motion);
        // Rounding, of what may cancel.
        EXPECT_LT(std::abs(all(h, i + count * j) - expected), 1e-12 * motion.cwiseAbs().maxCoeff());
      }
    }
}

TEST(Receptance, InvertsTheImpedance) {
  for (const char* name : {"landrover110_linkage", "landrover110_model3", "independent_roadster"}) {
    const Vehicle vehicle = ShippedVehicle(name);
    const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
    Receptance receptance(model, PortsOf(model), std::vector<double>(vehicle.posts.size(), 1));
    Eigen::MatrixXcd compliance;
    receptance.Compliance(20, 2, compliance);
    for (int h = 0; h <= 2; ++h) {
      const Eigen::MatrixXcd expected = receptance.vehicle().Impedance(20 * h).inverse();
      const Eigen::MatrixXcd given = compliance.row(h).reshaped(receptance.size(), receptance.size());
      // What linear models promise.
      EXPECT_LT((given - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff()) << name << h;
    }
  }
}

// Two equal oscillators have equal poles, and shapes that any mixture of both could be.
TEST(Receptance, InvertsTheImpedanceOfEqualOscillators) {
  CondensedModel model;
  model.mass = Eigen::MatrixXd::Identity(2, 2);
  model.damping = 2 * Eigen::MatrixXd::Identity(2, 2);
  model.stiffness = 100 * Eigen::MatrixXd::Identity(2, 2);
  model.post_stiffness = model.stiffness;
  model.post_damping = Eigen::MatrixXd::Zero(2, 2);
  Receptance receptance(model, {}, {1, 1});
  Eigen::MatrixXcd compliance;
  receptance.Compliance(5, 1, compliance);
  const Complex expected = 1.0 / Complex(100 - 25, 10);
  EXPECT_LT(std::abs(compliance(1, 0) - expected), 1e-12 * std::abs(expected));  // rounding
  EXPECT_LT(std::abs(compliance(1, 1)), 1e-12 * std::abs(expected));
  EXPECT_LT(std::abs(compliance(1, 3) - expected), 1e-12 * std::abs(expected));
}

// A critically damped mode has one pole twice and only one shape: sums over poles cannot have its motion.
TEST(Receptance, FactorisesWherePolesMeet) {
  CondensedModel model;
  model.mass = Eigen::MatrixXd::Identity(1, 1);
  model.damping = 20 * Eigen::MatrixXd::Identity(1, 1);
  model.stiffness = 100 * Eigen::MatrixXd::Identity(1, 1);
  model.post_stiffness = model.stiffness;
  model.post_damping = Eigen::MatrixXd::Zero(1, 1);
  const Receptance receptance(model, {}, {1});
  EXPECT_FALSE(receptance.by_poles());
  const Complex motion = receptance.Motion(5, Eigen::VectorXcd(0), 1)[0];
  EXPECT_LT(std::abs(motion - 100.0 / Complex(100 - 25, 100)), 1e-15);
}

}  // namespace
}  // namespace fourpost::receptance_test
