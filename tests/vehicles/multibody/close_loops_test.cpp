#include "vehicles/multibody/close_loops.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fourpost::close_loops_test {
namespace {

/// Equations of one unknown.
struct Scalar {
  double (*error)(double);
  double (*slope)(double);

  ClosedLoops CloseFrom(double start) const {
    double q = start;
    const LoopEquations equations{
        .error_at =
            [&](const Eigen::VectorXd& pose) {
              q = pose[0];
              return Eigen::VectorXd(Eigen::VectorXd::Constant(1, error(q)));
            },
        .jacobian = [&] { return Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, slope(q))); }};
    return CloseLoops(equations, Eigen::VectorXd::Constant(1, start));
  }
};

TEST(CloseLoops, ReachesWhatIsFarAlongALine) {
  const Scalar line{[](double q) { return q - 3; }, [](double) { return 1.0; }};
  const ClosedLoops loops = line.CloseFrom(0);
  EXPECT_TRUE(loops.is_closed);
  EXPECT_NEAR(loops.pose[0], 3, 1e-12);  // what counts as closed
}

// Newton's method alone runs away from starts beyond 1.39.
TEST(CloseLoops, DoesNotDiverge) {
  const Scalar arc{[](double q) { return std::atan(q); }, [](double q) { return 1 / (1 + q * q); }};
  for (const double start : {-10.0, -2.0, 1.0, 2.0, 10.0}) {
    const ClosedLoops loops = arc.CloseFrom(start);
    EXPECT_TRUE(loops.is_closed) << start;
    EXPECT_NEAR(loops.pose[0], 0, 1e-12) << start;
  }
}

// A circle of radius 1 and a line at 1.
TEST(CloseLoops, ClosesWhereTwoSolutionsMeet) {
  const Scalar touch{[](double q) { return q * q; }, [](double q) { return 2 * q; }};
  EXPECT_TRUE(touch.CloseFrom(0.3).is_closed);
}

TEST(CloseLoops, KeepsTheBestPoseOfWhatCannotBeClosed) {
  const Scalar apart{[](double q) { return (q - 1) * (q - 1) + 0.2; }, [](double q) { return 2 * (q - 1); }};
  for (const double start : {-1.0, 0.7, 2.0}) {
    const ClosedLoops loops = apart.CloseFrom(start);
    EXPECT_FALSE(loops.is_closed);
    // Within the last damping that is tried, which leaves a millionth of the error there.
    EXPECT_NEAR(loops.pose[0], 1, 1e-3) << start;
  }
}

TEST(CloseLoops, TakesTheNearestOfManySolutions) {
  const LoopEquations equations{
      .error_at = [](const Eigen::VectorXd& q) { return Eigen::VectorXd(Eigen::VectorXd::Constant(2, q.sum() - 0.2)); },
      .jacobian = [] { return Eigen::MatrixXd(Eigen::MatrixXd::Ones(2, 2)); }};
  const ClosedLoops loops = CloseLoops(equations, Eigen::VectorXd::Zero(2));
  EXPECT_TRUE(loops.is_closed);
  EXPECT_NEAR(loops.pose[0], 0.1, 1e-12);
  EXPECT_NEAR(loops.pose[1], 0.1, 1e-12);
}

}  // namespace
}  // namespace fourpost::close_loops_test
