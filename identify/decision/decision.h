#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// One of several settings is to be chosen by costs that are known with doubt: a row per setting, a column per draw, a
/// possible car. A column holds all settings of one car, so that differences between settings are paired: what all
/// settings share does not count.
struct Decision {
  /// The least mean cost of the admitted settings: the least expected loss.
  std::size_t best = 0;
  /// Mean cost.
  Eigen::VectorXd mean;
  /// Share of draws in which a setting is the best of the admitted ones, equals share it.
  Eigen::VectorXd best_probability;
  /// Mean over draws of the cost above the best setting of that draw.
  Eigen::VectorXd regret;
  /// Of each setting's cost minus the best one's: mean, standard deviation, and quantiles of 2.5 and 97.5 %.
  Eigen::VectorXd difference;
  Eigen::VectorXd difference_sd;
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  /// Admitted settings whose interval holds zero or lies below, the best included: these draws cannot tell them apart.
  std::vector<bool> is_indistinct;

  std::size_t IndistinctCount() const;
  /// The setting that is the best most often besides `best`, of equals the one with the least mean; `best` where no
  /// other is admitted.
  std::size_t Rival() const;

  std::vector<bool> is_admitted;
};

/// `cost`: settings x draws, finite in the rows of admitted settings. Throws std::invalid_argument where none is
/// admitted, or without a draw.
Decision Decide(const Eigen::MatrixXd& cost, const std::vector<bool>& is_admitted);

/// Mean, standard deviation, and quantiles of 2.5 and 97.5 % of draws, linear between them.
struct DrawSummary {
  double mean = 0;
  double sd = 0;
  double lower = 0;
  double upper = 0;
};
DrawSummary Summarise(const Eigen::VectorXd& draws);

/// Admitted settings of two costs that no other one beats in both, by rising first cost; of equals the first.
std::vector<std::size_t> ParetoFront(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                                     const std::vector<bool>& is_admitted);

}  // namespace fourpost
