#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// Something that can be measured, once or several times, and what it says of p parameters: readings with errors that
/// repeats average out, and errors that they do not.
struct PossibleRun {
  /// [s] for one of them.
  double cost_s = 0;
  int most_repeats = 1;
  /// Readings x p: change by each parameter.
  Eigen::MatrixXd slopes;
  /// Per reading: variance of one, divided by the number of repeats; and variance that stays.
  Eigen::VectorXd noise;
  Eigen::VectorXd floor;

  /// Inverse covariance of the parameters that this many repeats give, p x p.
  Eigen::MatrixXd Information(int repeats) const;
};

struct DesignGoal {
  /// At the most [s].
  double budget_s = 0;
  /// Standard deviations that p parameters should come below; infinite: it does not matter. None: all matter alike.
  Eigen::VectorXd targets;
};

struct ExperimentDesign {
  /// Of each possible run.
  std::vector<int> repeats;
  double cost_s = 0;
  /// Of the parameters, p x p.
  Eigen::MatrixXd covariance;
  /// Without targets: no design within the budget, of whole repeats or of parts, has standard deviations whose
  /// geometric mean is below this share of this design's.
  std::optional<double> efficiency;
  /// Whether every target is met.
  bool meets = true;
};

/// The repeats of each run that say most within the budget: of the smallest determinant of the covariance
/// (D-optimality), or with targets little time in which they are met. Repeats are added by what they give per
/// second, then exchanged one for another as long as that helps (Fedorov, Theory of optimal experiments, 1972); with
/// targets also in less and less time, until some attempts in a row miss one. The certificate is that of the
/// equivalence theorem (Kiefer and Wolfowitz 1960) with costs: the logarithm of the determinant is concave in the
/// numbers of repeats, of which parts count as much of what a whole one gives, so that its tangent anywhere bounds it;
/// the least bound on the way to the best design of parts (Frank and Wolfe 1956) counts. `known`: inverse covariance
/// without any run; it must be positive definite.
ExperimentDesign BestDesign(const Eigen::MatrixXd& known, const std::vector<PossibleRun>& runs, const DesignGoal& goal);

/// Covariance with these repeats.
Eigen::MatrixXd CovarianceWith(const Eigen::MatrixXd& known, const std::vector<PossibleRun>& runs,
                               const std::vector<int>& repeats);

}  // namespace fourpost
