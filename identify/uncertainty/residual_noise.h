#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "identify/residuals/residual_structure.h"

namespace fourpost {

/// What part of residuals is noise, judged by the residuals themselves, and how far it moves sums over them.
/// - Over frequency noise is independent, with the variance that second differences of neighbours leave: what a model
///   lacks is smooth and drops out.
/// - Over time it may be correlated from sample to sample and between the channels of a record. Its spectral matrix is
///   that of the residuals: an autoregression per channel, of the order that BIC prefers (Akaike 1974, Schwarz 1978;
///   solved by Levinson and Durbin), recoloured by the smoothed periodogram of what that leaves (prewhitening: Andrews
///   and Monahan, Econometrica 60, 1992). A fit takes noise with it at the frequencies that it rests on; the spectrum
///   makes up for that by the leverage there (HC2: MacKinnon and White, J. Econometrics 29, 1985).
/// - Residuals outside all series have their stated variance, 1.
class ResidualNoise {
 public:
  /// `residuals`: of the data, each times its weight in the gradient. `jacobian`, N x n: of the parameters that were
  /// fitted to them.
  ResidualNoise(const Eigen::VectorXd& residuals, const ResidualStructure& structure, const Eigen::MatrixXd& jacobian);

  /// Covariance of sum_i J_i r_i over the residuals i that `among` says with that over those that `with` says, n x n,
  /// for a Jacobian N x n: of the noise alone. Of N flags each.
  Eigen::MatrixXd CovarianceOfScores(const Eigen::MatrixXd& jacobian, const std::vector<char>& among,
                                     const std::vector<char>& with) const;
  /// The same of all residuals over time.
  Eigen::MatrixXd CovarianceOverTime(const Eigen::MatrixXd& jacobian) const;

  /// Covariance of sum_i b_i over the residuals over time that `among` says, for what noise of the inputs adds to the
  /// gradient, N x n: by the scatter of two dozen stretches of each record.
  Eigen::MatrixXd CovarianceOfStretches(const Eigen::MatrixXd& added, const std::vector<char>& among) const;

  bool HasTime() const { return !records_.empty(); }
  /// Of each residual: whether it belongs to a series over time.
  const std::vector<char>& over_time() const { return over_time_; }

 private:
  /// Channels over time that were recorded at once.
  struct Record {
    std::vector<ResidualSeries> channels;
    Eigen::Index samples = 0;
    /// Points of the transform, at least twice the samples.
    Eigen::Index points = 0;
    /// Per frequency from 0 to half the rate: channels x channels.
    std::vector<Eigen::MatrixXcd> spectrum;
  };

  /// What was fitted: a row for each residual, and what makes the columns orthonormal.
  struct FittedColumns {
    Eigen::MatrixXd all;
    Eigen::MatrixXd orthonormalising;
  };

  static Record Measured(std::vector<ResidualSeries> channels, const Eigen::VectorXd& residuals,
                         const FittedColumns& fitted);
  /// What a fit has left of each channel's noise, frequencies x channels, as a share.
  static Eigen::MatrixXd Kept(const Record& record, const FittedColumns& fitted);
  /// Of its channels, those of which something takes part, and transforms of their derivatives, frequencies x n each.
  struct Transforms {
    std::vector<Eigen::Index> channels;
    std::vector<Eigen::MatrixXcd> of;
  };
  static Transforms TransformsOf(const Record& record, const Eigen::MatrixXd& jacobian, const std::vector<char>& among);
  static Eigen::MatrixXd Covariance(const Record& record, const Transforms& one, const Transforms& other);

  /// Of residuals that are not over time.
  Eigen::VectorXd variance_;
  std::vector<char> over_time_;
  std::vector<Record> records_;
};

}  // namespace fourpost
