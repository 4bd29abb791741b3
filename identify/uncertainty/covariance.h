#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/search/lattice.h"

namespace fourpost {

/// Settings of the covariance.
struct CovarianceOptions {
  /// Singular values below this share of the largest count as zero: a model with kinks leaves differences of about
  /// 2e-4 where the exact value is zero. In (0, 1).
  double rank_threshold = 1e-3;
  /// A parameter is undetermined when its share of the undetermined directions (0..1) exceeds this; less is what noise
  /// of the differences leaves. In (0, 1).
  double share_threshold = 1e-2;
  /// Multiply standard deviations of the data by sqrt(cost / (N - rank)) when that exceeds 1: the model misses the data
  /// by more than their noise.
  bool inflate = true;
  /// Rows of the Jacobian whose samples were not measured; N counts the others.
  Eigen::Index unmeasured = 0;
  /// Parameters that take no part, such as those at a bound; the others are judged while these stay.
  std::vector<Eigen::Index> held = {};

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// What data and priors say about the parameters, to first order around a point; n of them are not held.
struct Covariance {
  /// Of the whitened Jacobian, n of them, largest first; with priors, of the Jacobian of both, the data's over the
  /// inflation.
  Eigen::VectorXd singular_values;
  /// Column i: the unit vector of FitVariables that belongs to singular value i; its largest component is positive.
  /// Rows of parameters that are held are zero.
  Eigen::MatrixXd directions;
  /// How many directions data and priors determine; columns rank..n-1 of `directions` they do not.
  int rank = 0;
  /// Largest singular value over the smallest; infinite when the rank is below n.
  double condition = 0;
  /// Largest singular value over the smallest that counts; infinite for rank 0.
  double determined_condition = 0;
  /// What the standard deviations of the data were multiplied by; at least 1.
  double inflation = 1;
  /// Standard deviations in FitVariables (relative for logarithmic ones, else share of the range) and in the
  /// parameters' units. Infinite for what is not determined, NaN for what is held.
  Eigen::VectorXd variable_sd;
  Eigen::VectorXd sd;
  /// Half width of an interval of 95 % in standard deviations: Student's for the residuals, priors among them, beyond
  /// the parameters.
  double reach_95 = 0;
};

/// From the Jacobian J of the data's whitened residuals with respect to FitVariables (N x n), dp/dx (n;
/// FitVariables::Slopes) and the data's cost there: (J^T J)^-1 by singular values. With rows P of priors (k x n):
/// (J^T J / inflation^2 + P^T P)^-1, for how far the model misses the data says nothing of the priors. A prior
/// determines what the data leave open, however weakly. Throws std::invalid_argument when the sizes do not match, an
/// entry is not finite or a place to hold is none of a parameter.
Covariance EstimateCovariance(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& slopes, double cost,
                              const CovarianceOptions& options = {}, const Eigen::MatrixXd& priors = {});

/// With noise that is not independent from residual to residual: variable_sd and sd from H^-1 M H^-1 in the directions
/// that are determined, with H = `hessian`, priors included, and M = `score`, the covariance of the gradient (Huber,
/// Proc. 5th Berkeley Symp., 1967), both n x n over all parameters.
void UseScoreCovariance(const Eigen::MatrixXd& hessian, const Eigen::MatrixXd& score, const Eigen::VectorXd& slopes,
                        Covariance& covariance);

/// Correlations of the parameters, n x n, ones on the diagonal; NaN in the rows and columns of what is not determined
/// or held.
Eigen::MatrixXd Correlations(const Covariance& covariance);

/// A direction in words: "m_body +1 %, k_front +0.98 %", what each parameter changes by when the strongest changes by
/// 1 % ("1 % of range" where FitVariables are not logarithmic); strongest first, below a twentieth of it left out.
std::string DescribeDirection(const Lattice& lattice, const Eigen::VectorXd& direction);

}  // namespace fourpost
