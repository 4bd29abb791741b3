#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/residuals/residual_structure.h"
#include "identify/uncertainty/residual_noise.h"

namespace fourpost {

/// What was fitted, at the optimum: n parameters that are judged, N residuals of the data.
struct FittedResiduals {
  /// d residuals / d FitVariables, N x n; and of the priors.
  Eigen::MatrixXd jacobian;
  Eigen::MatrixXd priors;
  /// What each residual adds to the gradient, N x n: J_i psi_i, less what noise of the inputs adds.
  Eigen::MatrixXd scores;
  /// That, N x n; empty: nothing.
  Eigen::MatrixXd input_noise;
  /// Of the loss, see RobustLoss::Weights().
  Eigen::VectorXd weights;
  /// n: whether the variable is the logarithm of its parameter.
  std::vector<bool> is_relative;
};

/// A part of the data that wants another value of a parameter than the rest.
struct Contradiction {
  /// Places among those judged and among the clusters.
  Eigen::Index parameter = 0;
  Eigen::Index cluster = 0;
  /// What the parameter would do without it, and over the standard deviation of that by noise.
  double shift = 0;
  double deviations = 0;
};

/// One way to part the data, and what each part says.
struct PartedData {
  std::string name;
  std::vector<std::string> clusters;
  /// n x clusters: by how much the parameters would move without this cluster, to first order. Empty with fewer than
  /// three clusters, of which nothing can be learnt.
  Eigen::MatrixXd shifts;
  /// n x clusters: standard deviation of that by noise alone.
  Eigen::MatrixXd by_noise;
  /// Squares of what the clusters pull by, over what noise lets them; about `degrees` where noise is all there is.
  double disagreement = 0;
  double degrees = 0;
  /// n: place of the cluster without which the parameter would have more than five times its deviation; -1: none.
  std::vector<int> rests_on;

  /// Whether noise explains the disagreement in less than one fit of a million (normal approximation of the chi-square
  /// distribution by Wilson and Hilferty, PNAS 17, 1931).
  bool IsSignificant() const;
  /// n x clusters: shifts, each less what noise alone lets it be, by squares.
  Eigen::MatrixXd BeyondNoise() const;
  /// Shifts larger than `least` (n) and more than four of their standard deviations by noise, which of a hundred shifts
  /// one in 160 fits has by chance; the largest first.
  std::vector<Contradiction> Contradictions(const Eigen::VectorXd& least) const;
};

/// How far the parameters are uncertain because the model is not the vehicle.
struct ModelErrorEstimate {
  std::vector<PartedData> ways;
  /// Recordings, where there are several: nothing rests on it, but it shows which contradict each other.
  PartedData by_recording;
  /// Parts of the data contradict each other beyond noise.
  bool is_significant = false;
  /// n, in FitVariables: half widths of intervals, see EstimateModelError().
  Eigen::VectorXd reach;
  /// n x n, in FitVariables: V, what it is raised by on its diagonal included.
  Eigen::MatrixXd covariance;
};

/// What parts of the data have in common of an error shows in none of their differences; random cars with richer
/// physics than their models, tests/validation/coverage.py --first 301 and 401, say how much that is.
inline constexpr double kErrorInCommon = 1.2;

/// A model that lacks something fits no two parts of the data by the same parameters; how far these go apart shows how
/// far they are from the truth. Delete-a-group jackknife (Shao and Wu, Ann. Stat. 17, 1989) over few physical clusters,
/// one Gauss-Newton step each, which takes no evaluation: with psi_i = w_i r_i, H = sum w_i J_i J_i' and the priors,
///   d_g = (H - H_g)^-1 sum_{i in g} J_i psi_i,   V_jj = c^2 (G - 1) / G sum_g max(0, d_gj^2 - its variance by noise),
/// mean over the ways, c = kErrorInCommon. Half widths are sqrt(V_jj) times Student's t of 95 %, with the degrees of
/// freedom of a sum of variances that have G - 1 each (Satterthwaite, Biometrics Bulletin 2, 1946): two ways that say
/// the same count as both, one that says it all as one. V_jj is at least m C_jj / 4, C = H^-1, m the median of V_jj /
/// C_jj, and at least (0.75)^2 of the median of all relative variances: what is missing moves all parameters, and where
/// all parts of the data agree on a wrong value V_jj is too small. On vehicles whose models lack much such intervals
/// hold the truth in 80 to 90 of 100, not in 95; nothing can be said of an error on which all parts agree.
ModelErrorEstimate EstimateModelError(const FittedResiduals& fitted, const ResidualStructure& structure,
                                      const ResidualNoise& noise);

}  // namespace fourpost
