#include "analysis/numerics/decompositions.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

namespace fourpost {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

Eigenpairs EigenpairsOf(const MatrixXd& matrix) {
  const Eigen::EigenSolver<MatrixXd> solver(matrix);
  if (solver.info() != Eigen::Success) return {};
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors(), .converged = true};
}

VectorXcd EigenvaluesOf(const MatrixXd& matrix) {
  return Eigen::EigenSolver<MatrixXd>(matrix, /*computeEigenvectors=*/false).eigenvalues();
}

SymmetricEigenpairs SymmetricEigenpairsOf(const MatrixXd& matrix) {
  if (matrix.size() == 0) return {.values = VectorXd(0), .vectors = MatrixXd(0, 0)};
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

SymmetricEigenpairs SymmetricEigenpairsOf(const MatrixXd& a, const MatrixXd& b) {
  if (a.size() == 0) return {.values = VectorXd(0), .vectors = MatrixXd(0, 0)};
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(a, b);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

VectorXd SymmetricEigenvaluesOf(const MatrixXd& matrix) {
  if (matrix.size() == 0) return VectorXd(0);
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

SingularValues SingularValuesOf(const MatrixXd& matrix, SingularValues::Sides sides) {
  if (matrix.size() == 0) {
    SingularValues none;
    if ((sides & SingularValues::kLeft) != 0) none.left = MatrixXd::Identity(matrix.rows(), matrix.rows());
    if ((sides & SingularValues::kRight) != 0) none.right = MatrixXd::Identity(matrix.cols(), matrix.cols());
    return none;
  }
  unsigned options = 0;
  if ((sides & SingularValues::kLeft) != 0) options |= Eigen::ComputeFullU;
  if ((sides & SingularValues::kRight) != 0) options |= Eigen::ComputeFullV;
  const Eigen::JacobiSVD<MatrixXd> svd(matrix, options);
  SingularValues result{.values = svd.singularValues(), .left = {}, .right = {}};
  if (svd.computeU()) result.left = svd.matrixU();
  if (svd.computeV()) result.right = svd.matrixV();
  return result;
}

struct LeastNorm::Factors {
  explicit Factors(const MatrixXd& matrix) : rows(matrix.rows()), cols(matrix.cols()) {}

  bool is_empty() const { return rows == 0 || cols == 0; }

  Eigen::Index rows;
  Eigen::Index cols;
  /// Of a matrix that is not empty.
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> of;
};

LeastNorm::LeastNorm(const MatrixXd& matrix) {
  auto factors = std::make_shared<Factors>(matrix);
  if (!factors->is_empty()) factors->of.compute(matrix);
  factors_ = std::move(factors);
}

LeastNorm::LeastNorm(const MatrixXd& matrix, double threshold) {
  auto factors = std::make_shared<Factors>(matrix);
  factors->of.setThreshold(threshold);
  if (!factors->is_empty()) factors->of.compute(matrix);
  factors_ = std::move(factors);
}

VectorXd LeastNorm::Solve(const VectorXd& right) const {
  if (factors_->is_empty()) return VectorXd::Zero(factors_->cols);
  return factors_->of.solve(right);
}

MatrixXd LeastNorm::Solve(const MatrixXd& right) const {
  if (factors_->is_empty()) return MatrixXd::Zero(factors_->cols, right.cols());
  return factors_->of.solve(right);
}

MatrixXd LeastNorm::PseudoInverse() const {
  if (factors_->is_empty()) return MatrixXd::Zero(factors_->cols, factors_->rows);
  return factors_->of.pseudoInverse();
}

Eigen::Index LeastNorm::rank() const { return factors_->is_empty() ? 0 : factors_->of.rank(); }

MatrixXd LeastNorm::NullSpace() const {
  if (factors_->is_empty()) return MatrixXd::Identity(factors_->cols, factors_->cols);
  // A P = Q T Z: the last rows of Z span what A does not see.
  const Eigen::Index empty = factors_->of.cols() - rank();
  return factors_->of.colsPermutation() * factors_->of.matrixZ().transpose().rightCols(empty);
}

VectorXd LeastSquares(const MatrixXd& matrix, const VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

VectorXd Solved(const MatrixXd& matrix, const VectorXd& right) { return matrix.partialPivLu().solve(right); }

MatrixXd Solved(const MatrixXd& matrix, const MatrixXd& right) { return matrix.partialPivLu().solve(right); }

VectorXcd Solved(const MatrixXcd& matrix, const VectorXcd& right) { return matrix.partialPivLu().solve(right); }

MatrixXcd Solved(const MatrixXcd& matrix, const MatrixXcd& right) { return matrix.partialPivLu().solve(right); }

MatrixXd Exponential(const MatrixXd& matrix) { return matrix.exp(); }

}  // namespace fourpost
