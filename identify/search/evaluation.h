#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include "analysis/process/deadline.h"

#include "identify/search/lattice.h"

namespace fourpost {

/// Why an evaluation has no cost.
enum class Failure {
  kNone,
  /// A residual, or the sum of their squares, is NaN or infinite.
  kNotFinite,
  /// The model threw; `detail` is what it said.
  kException,
  /// An equilibrium, an integration or a periodic response was not reached.
  kNotConverged,
  /// It took longer than its deadline.
  kTimedOut,
  /// The parameters make no vehicle, or violate a constraint.
  kInfeasible,
  /// There are no residuals, or not as many as the first evaluation gave.
  kWrongSize,
};

/// "not finite", "exception", ... for tables and logs.
std::string_view FailureName(Failure failure);

/// What evaluating a model at one set of parameter values gives: residuals or a failure, never a number for a failure.
struct Evaluation {
  /// Whitened residuals: difference over standard deviation, so that each is worth one unit.
  Eigen::VectorXd residuals;
  Failure failure = Failure::kNone;
  /// Failure in words.
  std::string detail;
  /// Of kInfeasible: how far constraints are violated, 0 when nobody says. It orders infeasible points among each
  /// other and never enters a cost.
  double violation = 0;

  bool ok() const { return failure == Failure::kNone; }

  /// Sum of the squared residuals, without a factor 1/2. Throws std::logic_error for a failure.
  double cost() const;
};

/// A failed evaluation.
Evaluation Failed(Failure failure, std::string detail);

/// An infeasible one: `violation` > 0, the sum of what each constraint is exceeded by as a share of its scale.
Evaluation Infeasible(double violation, std::string detail);

/// Tells values apart that print alike.
std::string BytesOf(const Eigen::VectorXd& values);

/// A model as the search sees it: from values, in the order of the lattice's axes, to an evaluation. Made of a function
/// of the values and a Deadline, or of the values alone where no evaluation can take long.
class ModelFunction {
 public:
  template <typename F>
  requires(!std::is_same_v<F, ModelFunction> &&
           std::is_invocable_r_v<Evaluation, F&, const Eigen::VectorXd&, const Deadline&>) ModelFunction(F function)
      : function_(std::move(function)) {}

  template <typename F>
  requires(!std::is_same_v<F, ModelFunction> && std::is_invocable_r_v<Evaluation, F&, const Eigen::VectorXd&>)
      ModelFunction(F function)
      : function_([function = std::move(function)](const Eigen::VectorXd& values, const Deadline&) {
          return function(values);
        }) {}

  Evaluation operator()(const Eigen::VectorXd& values, const Deadline& deadline = {}) const {
    return function_(values, deadline);
  }

 private:
  std::function<Evaluation(const Eigen::VectorXd& values, const Deadline& deadline)> function_;
};

/// What a search method or a refinement solves: find the values with the least sum of squared residuals.
struct Problem {
  Lattice lattice;
  /// Called from several threads at once.
  ModelFunction evaluate;
  /// How many residuals there are; 0 when nobody says. Least-squares methods need as many as parameters.
  Eigen::Index residual_count = 0;
  /// What an evaluation may take [s], in processor time of its thread. A fixed number, not one derived from evaluations
  /// so far: which of them fail must not depend on their order.
  double deadline_s = std::numeric_limits<double>::infinity();
  /// Of the residuals, relative: how far the solver behind them goes. It decides on the steps of differences.
  double accuracy = 1e-15;
  /// d residuals / d values, N x n, by the model itself, as automatic differentiation gives them; empty where only
  /// differences give them. May throw, as `evaluate` may.
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& values)> differentiate = {};
};

/// Evaluates under guard: exceptions, passed deadlines, residuals that are not finite or not there, and violations that
/// are not finite or below 0 become failures. A model that never asks its deadline cannot be ended. A lack of memory is
/// none of the values: throws std::bad_alloc.
Evaluation EvaluateGuarded(const Problem& problem, const Eigen::VectorXd& values);

}  // namespace fourpost
