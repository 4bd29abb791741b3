#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/work_hooks.h"
#include "identify/study/loaded_study.h"
#include "identify/suggest/addition.h"

namespace fourpost {

/// A parameter that something new would change, as a share of its value; of one whose range includes 0, of its range.
struct MovedParameter {
  std::string name;
  double share = 0;
};

/// Something that could be added, and what it would be worth.
struct SuggestedAddition {
  Addition addition;
  double amount = 0;
  /// SI, of Addition::parameters.
  std::vector<double> values;
  /// SI, of the study's free parameters: those that belong to these numbers, as far as it was confirmed. A fit with it
  /// begins there.
  Eigen::VectorXd others;
  /// Expected, and its share of the present cost that goes.
  double cost = 0;
  double fall = 0;
  /// Independent residuals that those left with it are worth.
  double effective = 0;
  /// See CriterionChange(); below 0: it is worth adding.
  double criterion = 0;
  /// Change of the criterion with it beside those of Suggestions::together; 0 of one that is not among them.
  double worth = 0;
  /// All that a hundredth changes, the largest first.
  std::vector<MovedParameter> moved;
  /// Places in the list of others that are worth adding and change the residuals alike: correlation above 0.95.
  std::vector<std::size_t> like;
};

/// An addition of which nothing is known.
struct UntestedAddition {
  /// "dry friction beside damper 'front'"
  std::string words;
  /// Why it could not be evaluated.
  std::string reason;
};

struct Suggestions {
  /// Those worth adding, the best first; then the others by their criterion. Without parts of a better one, such as one
  /// side of what is worth more on both.
  std::vector<SuggestedAddition> list;
  /// Which of the list explain the residuals together, by the criterion with the residuals' own size in place of the
  /// stated errors; by what each then moves the free parameters, in FitVariables, n x additions; and the residuals that
  /// are left, priors included. To first order.
  std::vector<std::size_t> together;
  Eigen::MatrixXd moved_together;
  Eigen::VectorXd left_together;
  /// By all of them.
  std::vector<MovedParameter> moves_together;
  /// At the fitted values, N x n in FitVariables; zero columns of parameters at their bounds.
  Eigen::MatrixXd jacobian;
  double cost = 0;
  /// Residuals, and how many independent ones these are worth.
  Eigen::Index residuals = 0;
  double effective = 0;
  /// Additions that were tried, and those of them that could not be evaluated.
  std::size_t tried = 0;
  std::vector<UntestedAddition> failed;
  std::int64_t evaluations = 0;
  bool is_interrupted = false;

  /// Where intervals cannot take account of it.
  void LeaveOutTogether() {
    together.clear();
    moves_together.clear();
  }

  /// How many of the list are worth adding.
  std::size_t Worthwhile() const;
};

/// What could be added to a fitted vehicle. `study`: prepared, and corrected as the fit ended; `values`: of its free
/// parameters, SI. `threads`: 0: one per processor. Throws FaultyInput.
Suggestions SuggestFor(const LoadedStudy& study, const Eigen::VectorXd& values, int threads, const WorkHooks& hooks);

}  // namespace fourpost
