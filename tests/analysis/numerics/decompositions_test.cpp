#include "analysis/numerics/decompositions.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::decompositions_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rounding of numbers of the size of one.
constexpr double kRounding = 1e-14;

MatrixXd Matrix(std::initializer_list<std::initializer_list<double>> rows) { return MatrixXd(rows); }

TEST(Decompositions, EigenpairsOfARotationAreOnTheUnitCircle) {
  const MatrixXd turn = Matrix({{0, -1}, {1, 0}});
  const Eigenpairs pairs = EigenpairsOf(turn);
  ASSERT_TRUE(pairs.converged);
  for (Eigen::Index i = 0; i < 2; ++i) {
    EXPECT_NEAR(std::abs(pairs.values[i].imag()), 1, kRounding);
    EXPECT_LT((turn * pairs.vectors.col(i) - pairs.values[i] * pairs.vectors.col(i)).norm(), kRounding);
  }
  EXPECT_LT((EigenvaluesOf(turn) - pairs.values).norm(), kRounding);
}

TEST(Decompositions, SymmetricEigenvaluesIncrease) {
  const MatrixXd matrix = Matrix({{2, 1}, {1, 2}});
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(matrix);
  EXPECT_NEAR(pairs.values[0], 1, kRounding);
  EXPECT_NEAR(pairs.values[1], 3, kRounding);
  EXPECT_LT((SymmetricEigenvaluesOf(matrix) - pairs.values).norm(), kRounding);
  // Against a second matrix twice the identity they are halves.
  EXPECT_LT((SymmetricEigenpairsOf(matrix, 2 * MatrixXd::Identity(2, 2)).values - pairs.values / 2).norm(), kRounding);
}

TEST(Decompositions, SingularValuesHaveTheSidesAskedFor) {
  const MatrixXd matrix = Matrix({{3, 0}, {0, 4}, {0, 0}});
  const SingularValues both = SingularValuesOf(matrix, SingularValues::kBoth);
  EXPECT_NEAR(both.values[0], 4, kRounding);
  EXPECT_NEAR(both.values[1], 3, kRounding);
  EXPECT_LT((both.left.leftCols(2) * both.values.asDiagonal() * both.right.transpose() - matrix).norm(), kRounding);
  EXPECT_EQ(both.left.cols(), 3);
  EXPECT_EQ(SingularValuesOf(matrix, SingularValues::kLeft).right.size(), 0);
  EXPECT_EQ(SingularValuesOf(matrix, SingularValues::kRight).left.size(), 0);
}

// As of a fit all of whose parameters are at bounds.
TEST(Decompositions, OfEmptyMatricesAreEmpty) {
  EXPECT_EQ(SymmetricEigenpairsOf(MatrixXd(0, 0)).values.size(), 0);
  EXPECT_EQ(SymmetricEigenpairsOf(MatrixXd(0, 0), MatrixXd(0, 0)).vectors.cols(), 0);
  EXPECT_EQ(SymmetricEigenvaluesOf(MatrixXd(0, 0)).size(), 0);
  EXPECT_EQ(SingularValuesOf(MatrixXd(0, 3), SingularValues::kRight).right, MatrixXd(MatrixXd::Identity(3, 3)));
  EXPECT_EQ(SingularValuesOf(MatrixXd(2, 0), SingularValues::kBoth).left, MatrixXd(MatrixXd::Identity(2, 2)));
}

TEST(LeastNorm, OfEmptyMatricesSolvesForZeros) {
  for (const LeastNorm& none : {LeastNorm(MatrixXd(0, 3)), LeastNorm(MatrixXd(0, 3), 1e-9)}) {
    EXPECT_EQ(none.Solve(VectorXd(VectorXd(0))), VectorXd(VectorXd::Zero(3)));
    EXPECT_EQ(none.Solve(MatrixXd(MatrixXd(0, 2))), MatrixXd(MatrixXd::Zero(3, 2)));
    EXPECT_EQ(none.rank(), 0);
    EXPECT_EQ(none.NullSpace(), MatrixXd(MatrixXd::Identity(3, 3)));
  }
  EXPECT_EQ(LeastNorm(MatrixXd(2, 0)).PseudoInverse().cols(), 2);
}

TEST(LeastNorm, TakesTheShortestSolution) {
  const LeastNorm sum(Matrix({{1, 1}}));
  EXPECT_LT((sum.Solve(VectorXd(VectorXd::Constant(1, 2))) - VectorXd::Ones(2)).norm(), kRounding);
  EXPECT_LT((sum.PseudoInverse() - MatrixXd::Constant(2, 1, 0.5)).norm(), kRounding);
  EXPECT_EQ(sum.rank(), 1);
  const MatrixXd null = sum.NullSpace();
  ASSERT_EQ(null.cols(), 1);
  EXPECT_NEAR(null.sum(), 0, kRounding);
  EXPECT_NEAR(null.norm(), 1, kRounding);
}

TEST(LeastNorm, LeavesOutWhatIsBelowItsThreshold) {
  const MatrixXd matrix = Matrix({{1, 0}, {0, 1e-3}});
  EXPECT_EQ(LeastNorm(matrix, 1e-2).rank(), 1);
  EXPECT_EQ(LeastNorm(matrix, 1e-4).rank(), 2);
}

TEST(Decompositions, SolveSquareAndTallMatrices) {
  const MatrixXd square = Matrix({{0, 2}, {1, 0}});
  EXPECT_LT((Solved(square, VectorXd(Eigen::Vector2d(2, 3))) - Eigen::Vector2d(3, 1)).norm(), kRounding);
  EXPECT_LT((Solved(square, square) - MatrixXd::Identity(2, 2)).norm(), kRounding);
  const Eigen::MatrixXcd complex = square.cast<std::complex<double>>() * std::complex<double>(0, 1);
  EXPECT_LT((Solved(complex, complex) - Eigen::MatrixXcd::Identity(2, 2)).norm(), kRounding);
  EXPECT_NEAR(LeastSquares(Matrix({{1}, {1}}), VectorXd(Eigen::Vector2d(1, 3)))[0], 2, kRounding);
}

TEST(Decompositions, ExponentialOfAGeneratorIsARotation) {
  const double angle = std::numbers::pi / 3;
  const MatrixXd turned = Exponential(Matrix({{0, -angle}, {angle, 0}}));
  EXPECT_NEAR(turned(0, 0), 0.5, kRounding);
  EXPECT_NEAR(turned(1, 0), std::sin(angle), kRounding);
}

}  // namespace
}  // namespace fourpost::decompositions_test
