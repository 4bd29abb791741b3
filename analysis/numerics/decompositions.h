#pragma once

#include <memory>

#include <Eigen/Core>

namespace fourpost {

// Eigen's decompositions of dense matrices behind plain types, so that one source compiles them. Matrices without rows
// or columns have none of Eigen's, but values all the same.

/// Right eigenvectors, as columns of norm 1, and eigenvalues of a square matrix.
struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
  /// False where the iteration did not converge.
  bool converged = false;
};
Eigenpairs EigenpairsOf(const Eigen::MatrixXd& matrix);
/// Without vectors.
Eigen::VectorXcd EigenvaluesOf(const Eigen::MatrixXd& matrix);

/// Increasing eigenvalues of a symmetric matrix, of which the lower triangle is read, and orthonormal eigenvectors.
struct SymmetricEigenpairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigenpairs SymmetricEigenpairsOf(const Eigen::MatrixXd& matrix);
/// A x = value B x, with B positive definite.
SymmetricEigenpairs SymmetricEigenpairsOf(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// Without vectors.
Eigen::VectorXd SymmetricEigenvaluesOf(const Eigen::MatrixXd& matrix);

/// A = U S V' with square U and V, as far as they are asked for; singular values decrease.
struct SingularValues {
  enum Sides : unsigned { kLeft = 1, kRight = 2, kBoth = 3 };
  Eigen::VectorXd values;
  Eigen::MatrixXd left;
  Eigen::MatrixXd right;
};
SingularValues SingularValuesOf(const Eigen::MatrixXd& matrix, SingularValues::Sides sides);

/// The shortest of the best solutions of A x = b, also of a matrix without full rank.
class LeastNorm {
 public:
  /// `threshold`: pivots below this share of the largest count as zero.
  explicit LeastNorm(const Eigen::MatrixXd& matrix);
  LeastNorm(const Eigen::MatrixXd& matrix, double threshold);

  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& right) const;
  Eigen::MatrixXd PseudoInverse() const;
  Eigen::Index rank() const;
  /// Orthonormal columns that A takes to zero.
  Eigen::MatrixXd NullSpace() const;

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

/// Least squares of a matrix of full rank.
Eigen::VectorXd LeastSquares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// A x = b of a square matrix, by LU with partial pivoting.
Eigen::VectorXd Solved(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
Eigen::MatrixXd Solved(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
Eigen::VectorXcd Solved(const Eigen::MatrixXcd& matrix, const Eigen::VectorXcd& right);
Eigen::MatrixXcd Solved(const Eigen::MatrixXcd& matrix, const Eigen::MatrixXcd& right);

Eigen::MatrixXd Exponential(const Eigen::MatrixXd& matrix);

}  // namespace fourpost
