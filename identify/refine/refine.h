#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "identify/refine/difference_jacobian.h"
#include "identify/refine/known_optima.h"
#include "identify/refine/robust_loss.h"
#include "identify/search/archive.h"

namespace fourpost {

/// Settings of the refinement.
struct RefineOptions {
  int max_iterations = 100;
  /// Step of the differences in the fit variables: relative for logarithmic ones, else a share of the range; in [0,
  /// 0.1]. 0: what the problem's accuracy asks for, see DifferenceStep().
  double step = 0;
  /// Automatic: the model's own derivatives; without them forward differences where more than ten standard deviations
  /// or a tenth of the cost may still be gained, central ones nearer to the optimum.
  Differences differences = Differences::kCentral;
  /// Converged when the cost falls by less than this share in an iteration; in (0, 1).
  double cost_tolerance = 1e-8;
  /// Converged when the variables move by less than this share of their norm; in (0, 1).
  double step_tolerance = 1e-8;
  /// Converged when the residuals, were they linear, would put no variable further from its optimum than this share of
  /// its standard deviation, by the spread of the residuals, or when two steps lower the cost by no more than that
  /// would; in [0, 1), 0: never.
  double nearness = 0;
  /// Two runs agree when the worse cost exceeds the better by less than this much of chi-square; in (0, 1). Its unit is
  /// the better cost over its degrees of freedom, residuals less variables, so that it does not depend on how well the
  /// noise is known: within 0.1 of it values differ by at most a third of their deviations, which no data can resolve.
  /// But 100 times `cost_tolerance` of the cost, which is what the solver leaves, agree as well, and a cost below 1e-12
  /// of the highest starting cost counts as zero, since all that is left of it is rounding.
  double agreement = 0.1;
  /// Of the residuals; the cost is its sum. Where most residuals are outliers, as far from the optimum, a robust loss
  /// barely shows the way down: squares go before Huber's and soft_l1, Huber's of the same scale before Cauchy's and
  /// Tukey's.
  RobustLoss loss;
  /// Ends a run that, after three iterations, heads for a cost above this one: that of now less three times all further
  /// gains, if each shrinks as the last one did, but by no more than half and no less than a tenth.
  double give_up_above = std::numeric_limits<double>::infinity();
  /// Variables that stay where the start has them.
  std::vector<Eigen::Index> held = {};

  double DifferenceStep(const Problem& problem) const {
    return step > 0 ? step : StepFor(problem.accuracy, differences);
  }

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

enum class RefineEnd {
  kNotRun,
  kConverged,
  kIterations,
  /// The model could not be evaluated at the start.
  kStartFailed,
  /// The last step tried, or the Jacobian after it, could not be evaluated; the optimum may be elsewhere.
  kFailed,
  kStopped,
  /// See RefineOptions::give_up_above.
  kGivenUp,
  /// See KnownOptima::MetBy().
  kKnown,
};

/// "converged", ...
std::string_view RefineEndName(RefineEnd end);

/// The outcome of a refinement from one start.
struct RefineResult {
  RefineEnd end = RefineEnd::kNotRun;
  /// Why it ended, in the words of the optimiser or of the evaluation that failed.
  std::string message;
  /// Parameters at the end, within their bounds; the start when that failed.
  Eigen::VectorXd values;
  /// Sums of the loss, by default of squares; meaningful unless `end` is kNotRun or kStartFailed.
  double start_cost = 0;
  double cost = 0;
  Eigen::VectorXd residuals;
  /// d residuals / d FitVariables at `values`; empty when it could not be evaluated.
  Eigen::MatrixXd jacobian;
  int iterations = 0;
  /// New evaluations, those for differences included.
  std::int64_t evaluations = 0;
  /// The same of coarse residuals, which led it.
  std::int64_t coarse_evaluations = 0;
  /// Of the known optima the one that it met.
  std::optional<std::size_t> met;
  /// Of several that ended: with the best, itself included, see RefineOptions::agreement.
  bool agrees = false;

  bool has_cost() const { return end != RefineEnd::kNotRun && end != RefineEnd::kStartFailed; }
  /// By itself, not by the user.
  bool has_ended() const {
    return end != RefineEnd::kNotRun && end != RefineEnd::kStopped && end != RefineEnd::kGivenUp;
  }
};

/// Levenberg-Marquardt (Ceres) within the bounds of the lattice, in FitVariables, with differences evaluated in
/// parallel; the precision of the lattice plays no part. Variables held at a bound by the cost stay out of the steps of
/// the others. A step whose evaluation fails is refused and a shorter one tried. `stop` is asked after each iteration.
/// Where it meets one of the `known` optima it ends, short of it. `at_start`: what the start gives, where that has been
/// evaluated. Throws std::invalid_argument for a start out of bounds.
RefineResult Refine(Archive& archive, const Eigen::VectorXd& start, const RefineOptions& options = {},
                    const std::function<bool()>& stop = {}, const KnownOptima& known = {},
                    const Evaluation* at_start = nullptr);

}  // namespace fourpost
