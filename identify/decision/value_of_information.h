#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// What the doubt of one parameter does to a decision.
struct DecidingParameter {
  std::size_t parameter = 0;
  /// Share of the variance of the difference between two settings that goes with it: by how much that variance would
  /// fall if it were known. Shares of parameters that are correlated overlap.
  double explained = 0;
  /// By how much the expected regret of the best setting would fall if it were known, in the unit of the costs.
  double gain = 0;
};

/// Each parameter by linear regression over the draws, the largest gain first, then by `explained`. `cost`: settings x
/// draws, of the settings that are to be distinguished; `best`, `rival`: rows of it; `parameters`: draws x parameters.
/// A squared correlation r^2 of n draws is corrected for chance as r^2 - (1 - r^2) / (n - 2), and a slope is shrunk
/// accordingly. The gain is the expected value of partial perfect information by regression (Strong, Oakley and
/// Brennan, Med. Decis. Making 34, 2014). Empty for fewer than 10 draws.
std::vector<DecidingParameter> DecidingParameters(const Eigen::MatrixXd& cost, std::size_t best, std::size_t rival,
                                                  const Eigen::MatrixXd& parameters);

/// E[max_i (a_i + b_i Z)] - max_i a_i of a standard normal Z: exact, by the upper envelope of the lines (Frazier,
/// Powell and Dayanik, INFORMS J. Comput. 21, 2009, algorithm 1). Never below 0.
double ExpectedRise(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// A run on the rig: one setting, measured beside the present one.
struct InformativeRun {
  /// Row of the costs.
  std::size_t setting = 0;
  /// By how much it lowers the expected cost of the setting that is chosen after it, given the runs before it.
  double gain = 0;
  /// Standard deviation of the setting's cost before and after the run.
  double sd_before = 0;
  double sd_after = 0;
};

/// The most informative runs, each of another setting and given those before it, at most `count`, until none gains
/// anything: knowledge gradient with correlated beliefs (Frazier, Powell and Dayanik 2009). Beliefs are normal, mean
/// and covariance those of the draws; `noise`: standard deviation of one run's cost. A run changes the belief in all
/// settings that are correlated with it.
std::vector<InformativeRun> InformativeRuns(const Eigen::MatrixXd& cost, double noise, std::size_t count);

}  // namespace fourpost
