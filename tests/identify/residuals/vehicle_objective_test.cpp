#include "identify/residuals/vehicle_objective.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::vehicle_objective_test {
namespace {

Parameter Named(const std::string& name, double value) {
  Parameter parameter;
  parameter.name = name;
  parameter.value = value;
  parameter.lower = 0.1 * value;
  parameter.upper = 10 * value;
  parameter.precision = 1e-3;
  return parameter;
}

/// Two residuals of parameters a = 2, b = 3 and c = 5 of which `free` vary; a is known to 0.5, b is like a and c like
/// b.
VehicleObjective Likened(std::vector<std::size_t> free) {
  Vehicle vehicle;
  vehicle.parameters = {Named("a", 2), Named("b", 3), Named("c", 5)};
  vehicle.parameters[0].prior_sd = 0.5;
  vehicle.parameters[1].like = Parameter::Likeness{"a", 0.1};
  vehicle.parameters[2].like = Parameter::Likeness{"b", 0.2};
  ResidualBlock block{.name = "data", .count = 2};
  block.evaluate = [](const std::vector<double>& p, const Deadline&) {
    return Evaluation{.residuals = Eigen::Vector2d(p[0] * p[1], p[2])};
  };
  block.differentiate = [](const std::vector<double>& p, const std::vector<std::size_t>& by) {
    Eigen::MatrixXd all(2, 3);
    all << p[1], p[0], 0, 0, 0, 1;
    Eigen::MatrixXd some(2, static_cast<Eigen::Index>(by.size()));
    for (std::size_t j = 0; j < by.size(); ++j)
      some.col(static_cast<Eigen::Index>(j)) = all.col(static_cast<Eigen::Index>(by[j]));
    return some;
  };
  return {std::move(vehicle), std::move(free), {std::move(block)}};
}

TEST(VehicleObjective, EndsWithPriorsOfParametersAndRatios) {
  const VehicleObjective objective = Likened({0, 1, 2});
  EXPECT_EQ(objective.prior_count(), 3);
  const Eigen::VectorXd residuals = objective.Evaluate(Eigen::Vector3d(3, 4, 6)).residuals;
  ASSERT_EQ(residuals.size(), 5);
  EXPECT_DOUBLE_EQ(residuals[2], (3 - 2) / 0.5);
  EXPECT_DOUBLE_EQ(residuals[3], (std::log(4.0 / 3) - std::log(3.0 / 2)) / 0.1);
  EXPECT_DOUBLE_EQ(residuals[4], (std::log(6.0 / 4) - std::log(5.0 / 3)) / 0.2);
}

TEST(VehicleObjective, HasNoPriorAtTheValuesOfTheFile) {
  const VehicleObjective objective = Likened({0, 1, 2});
  EXPECT_EQ(objective.PriorResiduals(objective.FileValues()).norm(), 0);
}

TEST(VehicleObjective, ComparesWithAParameterThatIsHeld) {
  const VehicleObjective objective = Likened({1});
  EXPECT_EQ(objective.prior_count(), 2);
  const Eigen::VectorXd residuals = objective.PriorResiduals(Eigen::VectorXd::Constant(1, 6));
  EXPECT_DOUBLE_EQ(residuals[0], std::log(2.0) / 0.1);
  EXPECT_DOUBLE_EQ(residuals[1], -std::log(2.0) / 0.2);
}

TEST(VehicleObjective, LeavesOutRatiosOfHeldParameters) { EXPECT_EQ(Likened({0}).prior_count(), 2); }

TEST(VehicleObjective, DerivativesAreThoseOfDifferences) {
  // Central differences err by the square of the step and by rounding over it.
  constexpr double kStep = 1e-5;
  for (const std::vector<std::size_t>& free : {std::vector<std::size_t>{0, 1, 2}, {1}, {2, 0}}) {
    const VehicleObjective objective = Likened(free);
    const Eigen::VectorXd at = 1.3 * objective.FileValues();
    const Eigen::MatrixXd jacobian = objective.Jacobian(at);
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(at.size(), j);
      const Eigen::VectorXd by_differences =
          (objective.Evaluate(at + step).residuals - objective.Evaluate(at - step).residuals) / (2 * kStep);
      EXPECT_LT((jacobian.col(j) - by_differences).norm(), 1e-8) << j << " of " << free.size();
    }
  }
}

}  // namespace
}  // namespace fourpost::vehicle_objective_test
