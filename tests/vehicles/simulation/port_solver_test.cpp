#include "vehicles/simulation/port_solver.h"

#include <vector>

#include <gtest/gtest.h>

namespace fourpost::port_solver_test {
namespace {

std::vector<Port> Ports() {
  const Eigen::VectorXd direction = Eigen::VectorXd::Ones(1);
  return {{.direction = direction, .law = DashpotRemainder{DashpotLaw(500, 3500).WithFriction(80, 0.002), 2000}},
          {.direction = direction,
           .law = SpringRemainder{{.knees = {{.at = -0.01, .side = -1, .stiffness = 4e5, .cubic = 1e9}}}, 0}},
          {.direction = direction, .law = LiftoffRemainder{.preload = 500, .stiffness = 2e5, .damping = 50}}};
}

/// What the laws make of a solution must be the solution.
TEST(PortSolver, FindsForcesThatTheirMotionsHave) {
  const std::vector<Port> ports = Ports();
  Eigen::Matrix3d by_extension;
  by_extension << -2e-9, 1e-9, 5e-10, 1e-9, -3e-9, 0, 5e-10, 0, -1e-8;
  Eigen::Matrix3d by_rate;
  by_rate << -4e-4, 1e-5, 2e-5, 1e-5, -5e-5, 0, 2e-5, 0, -3e-4;
  PortSolver solver(ports, 1e-3);
  solver.SetCompliance(by_extension, by_rate);
  Eigen::VectorXd remainder = Eigen::VectorXd::Zero(3);
  for (const double size : {-3.0, -0.3, -1e-3, 0.0, 1e-3, 0.4, 2.0}) {
    const Eigen::Vector3d extension(0, 0.01 * size, 0.004 * size);
    const Eigen::Vector3d rate(0.5 * size, 0, 0.2 * size);
    ASSERT_TRUE(solver.Solve(3, extension, rate, remainder)) << size;
    const Eigen::Vector3d e = extension + by_extension * remainder;
    const Eigen::Vector3d v = rate + by_rate * remainder;
    for (Eigen::Index j = 0; j < 3; ++j) {
      double law = 0;
      Remainders(ports[static_cast<std::size_t>(j)].law, {&e[j], 1}, {&v[j], 1}, {&law, 1});
      // 1e-11 of some kN, times how the laws pass it on.
      EXPECT_NEAR(remainder[j], law, 1e-6) << size << ' ' << j;
    }
  }
}

// As if the others were not there.
TEST(PortSolver, SolvesForTheFirstPortsAlone) {
  const Eigen::Matrix3d compliance = -1e-4 * Eigen::Matrix3d::Ones();
  PortSolver all(Ports(), 1e-3);
  all.SetCompliance(Eigen::Matrix3d::Zero(), compliance);
  const std::vector<Port> ports = Ports();
  PortSolver first({ports.begin(), ports.begin() + 2}, 1e-3);
  first.SetCompliance(Eigen::Matrix2d::Zero(), compliance.topLeftCorner<2, 2>());
  const Eigen::Vector3d extension(0, -0.02, -0.01);
  const Eigen::Vector3d rate(0.4, 0, 0);
  Eigen::VectorXd some = Eigen::Vector3d(0, 0, 7);
  Eigen::VectorXd alone = Eigen::VectorXd::Zero(2);
  ASSERT_TRUE(all.Solve(2, extension, rate, some));
  ASSERT_TRUE(first.Solve(2, extension.head<2>(), rate.head<2>(), alone));
  EXPECT_EQ(some.head<2>(), alone.head<2>());
  EXPECT_EQ(some[2], 0);
}

// r = (500 - 2000) v and v = 0.1 - 1e-4 r.
TEST(PortSolver, SolvesALineInOneStep) {
  PortSolver solver({{.direction = Eigen::VectorXd::Ones(1), .law = DashpotRemainder{DashpotLaw(500, 500), 2000}}},
                    1e-3);
  solver.SetCompliance(Eigen::MatrixXd::Zero(1, 1), Eigen::MatrixXd::Constant(1, 1, -1e-4));
  Eigen::VectorXd remainder = Eigen::VectorXd::Zero(1);
  ASSERT_TRUE(solver.Solve(1, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 0.1), remainder));
  EXPECT_NEAR(remainder[0], -1500 * 0.1 / (1 - 0.15), 1e-9);
}

}  // namespace
}  // namespace fourpost::port_solver_test
