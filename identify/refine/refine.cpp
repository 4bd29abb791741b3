#include "identify/refine/refine.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <ceres/ceres.h>
#include <glog/logging.h>

#include "analysis/numerics/decompositions.h"
#include "analysis/text/number.h"
#include "analysis/text/option_check.h"
#include "identify/refine/difference_jacobian.h"
#include "identify/refine/fit_variables.h"

namespace fourpost {
namespace {

// Residuals, and where they hold.
struct Residuals {
  Eigen::VectorXd x;
  Eigen::VectorXd residuals;
};

// The residuals as Ceres wants them; remembers the latest ones and the latest Jacobian, for which Ceres asks apart.
class ResidualFunction : public ceres::CostFunction {
 public:
  ResidualFunction(Archive& archive, const FitVariables& variables, const RefineOptions& options,
                   const Eigen::VectorXd& x, const Eigen::VectorXd& residuals)
      : archive_(archive), variables_(variables), options_(options), loss_(options.loss), here_{x, residuals} {
    set_num_residuals(static_cast<int>(residuals.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(x.size()));
  }

  // False for a failed evaluation: Ceres then refuses the step.
  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], parameter_block_sizes()[0]);
    if (!MoveTo(x)) return false;
    const Eigen::VectorXd transformed = loss_.Transformed(here_.residuals);
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = transformed;
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    Eigen::Map<RowMajor> free(jacobians[0], num_residuals(), x.size());
    if (MayBeFar()) {
      if (!Linearise(Differences::kForward)) return false;
      FindFree(transformed, free);
      if (IsFar(transformed.squaredNorm())) return true;
      is_near_ = true;
    }
    if (!Linearise(options_.differences)) return false;
    FindFree(transformed, free);
    return true;
  }

  /// By how much the cost would fall if the residuals were linear, from where the latest Jacobian was asked for.
  double full_gain() const { return full_gain_; }
  /// Residuals less variables.
  double freedom() const {
    return static_cast<double>(std::max<Eigen::Index>(1, here_.residuals.size() - here_.x.size()));
  }

  bool MoveTo(const Eigen::VectorXd& x) const {
    if (x == here_.x) return true;
    if (linearised_ && x == linearised_->x) {
      here_ = *linearised_;
      return true;
    }
    const Evaluation evaluation = archive_.EvaluateValues({variables_.ToValues(x)}).front();
    if (!evaluation.ok()) {
      failure_ = evaluation.detail.empty() ? FailureName(evaluation.failure) : evaluation.detail;
      return false;
    }
    here_ = {x, evaluation.residuals};
    return true;
  }

  // To the better of the two points remembered.
  void MoveToBest() const {
    if (linearised_ && loss_.Cost(linearised_->residuals) < loss_.Cost(here_.residuals)) here_ = *linearised_;
  }

  // The Jacobian where MoveTo() went.
  bool Linearise(Differences differences) const {
    if (linearised_ && here_.x == linearised_->x && linearised_by_ == differences) return true;
    const double step = options_.step > 0 ? options_.step : StepFor(archive_.problem().accuracy, differences);
    std::optional<Eigen::MatrixXd> jacobian =
        DifferenceJacobian(archive_, variables_, here_.x, here_.residuals, step, differences);
    if (!jacobian) return false;
    linearised_ = here_;
    linearised_by_ = differences;
    jacobian_ = *std::move(jacobian);
    failure_.clear();
    return true;
  }

  const Eigen::VectorXd& residuals() const { return here_.residuals; }
  const Eigen::MatrixXd& jacobian() const { return jacobian_; }
  const Eigen::VectorXd& x() const { return here_.x; }
  // Where the latest Jacobian holds.
  const Eigen::VectorXd& linearised_x() const { return linearised_->x; }
  /// Whether the latest Jacobian is good for the way only, not for an end.
  bool is_far() const { return MayBeFar() && linearised_by_ == Differences::kForward; }
  /// From here on with the differences of an end.
  void BeNear() { is_near_ = true; }
  // Why a step from the point of the Jacobian was refused; empty when none was.
  const std::string& failure() const { return failure_; }

 private:
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// Whether forward differences, at half the price, might do.
  bool MayBeFar() const {
    return options_.differences == Differences::kAutomatic && !archive_.problem().differentiate && !is_near_;
  }

  /// Whether a run may still gain so much that the errors of forward differences do not lead it astray: ten standard
  /// deviations, or of few residuals a tenth of the cost.
  bool IsFar(double cost) const {
    constexpr double kDeviations = 10;
    constexpr double kShare = 0.1;
    return full_gain_ > std::min(kDeviations * kDeviations / freedom(), kShare) * cost;
  }

  /// The Jacobian of the transformed residuals, without the columns of variables that are held.
  void FindFree(const Eigen::VectorXd& transformed, Eigen::Map<RowMajor>& free) const {
    const Eigen::VectorXd slopes = loss_.Slopes(here_.residuals);
    const Eigen::VectorXd gradient = jacobian_.transpose() * slopes.cwiseProduct(transformed);
    free = slopes.asDiagonal() * jacobian_;
    for (Eigen::Index j = 0; j < free.cols(); ++j) {
      if (IsHeld(j, gradient[j])) free.col(j).setZero();
    }
    FindFullGain(free, transformed);
  }

  void FindFullGain(const Eigen::Ref<const Eigen::MatrixXd>& jacobian, const Eigen::VectorXd& residuals) const {
    const Eigen::VectorXd norms = jacobian.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
    const Eigen::MatrixXd scaled = jacobian * norms.cwiseInverse().asDiagonal();
    const Eigen::VectorXd gradient = scaled.transpose() * residuals;
    full_gain_ = gradient.dot(LeastNorm(scaled.transpose() * scaled).Solve(gradient));
  }

  // By the options, or at a bound, and the cost falls beyond it. Ceres computes a step as if there were no bounds and
  // cuts it off there, which leaves the other variables short of their optimum; without its column in the Jacobian,
  // this one has no part in it.
  bool IsHeld(Eigen::Index j, double gradient) const {
    const std::vector<Eigen::Index>& held = options_.held;
    if (std::find(held.begin(), held.end(), j) != held.end()) return true;
    return gradient > 0 ? here_.x[j] <= variables_.lower()[j] : here_.x[j] >= variables_.upper()[j];
  }

  Archive& archive_;
  const FitVariables& variables_;
  const RefineOptions& options_;
  const RobustLoss& loss_;
  // Ceres evaluates through const.
  mutable Residuals here_;
  mutable std::optional<Residuals> linearised_;
  mutable Differences linearised_by_ = Differences::kAutomatic;
  mutable bool is_near_ = false;
  mutable Eigen::MatrixXd jacobian_;
  mutable std::string failure_;
  mutable double full_gain_ = std::numeric_limits<double>::infinity();
};

/// Ends a run after an iteration: by `stop`, because the optimum is as near as it has to be or known, or because the
/// run heads for too high a cost.
class EndOfRun : public ceres::IterationCallback {
 public:
  EndOfRun(const std::function<bool()>& stop, const RefineOptions& options, const KnownOptima& known,
           const ResidualFunction& function)
      : stop_(stop), options_(options), known_(known), function_(function) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& iteration) override {
    if (stop_ && stop_()) return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    if (IsNear(iteration)) end_ = RefineEnd::kConverged;
    else if ((met_ = Met(iteration))) end_ = RefineEnd::kKnown;
    else if (HeadsTooHigh(iteration)) end_ = RefineEnd::kGivenUp;
    return end_ == RefineEnd::kNotRun ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

  /// kNotRun where the optimiser ended it.
  RefineEnd end() const { return end_; }
  std::optional<std::size_t> met() const { return met_; }

 private:
  /// The square of the way to the optimum in standard deviations, of which no variable's own way is longer, is what the
  /// cost still falls by over its mean per degree of freedom. Derivatives that are good for steps only may see no end:
  /// then two short steps do.
  bool IsNear(const ceres::IterationSummary& iteration) {
    // Ceres halves costs.
    const double small = options_.nearness * options_.nearness * 2 * iteration.cost / function_.freedom();
    if (iteration.iteration > 0 && iteration.step_is_successful)
      short_steps_ = 2 * iteration.cost_change < small ? short_steps_ + 1 : 0;
    return function_.full_gain() < small || short_steps_ == 2;
  }

  std::optional<std::size_t> Met(const ceres::IterationSummary& iteration) const {
    // Ceres halves costs.
    return known_.MetBy({.x = function_.linearised_x(),
                         .cost = 2 * iteration.cost,
                         .full_gain = function_.full_gain(),
                         .freedom = function_.freedom()},
                        options_.agreement);
  }

  bool HeadsTooHigh(const ceres::IterationSummary& iteration) {
    constexpr int kLeastIterations = 3;
    // Gains of a descent along a valley grow again.
    constexpr double kCaution = 3;
    if (iteration.iteration == 0 || !iteration.step_is_successful) return false;
    // Ceres halves costs.
    const double gain = 2 * iteration.cost_change;
    const double ratio = last_gain_ > 0 ? std::clamp(gain / last_gain_, 0.5, 0.9) : 0.9;
    last_gain_ = gain;
    return iteration.iteration >= kLeastIterations &&
           2 * iteration.cost - kCaution * gain * ratio / (1 - ratio) > options_.give_up_above;
  }

  const std::function<bool()>& stop_;
  const RefineOptions& options_;
  const KnownOptima& known_;
  const ResidualFunction& function_;
  double last_gain_ = 0;
  int short_steps_ = 0;
  std::optional<std::size_t> met_;
  RefineEnd end_ = RefineEnd::kNotRun;
};

// Ceres reports refused steps as warnings on stderr, where they would break up a progress line.
void QuietGlog() {
  static const bool quiet = [] {
    FLAGS_minloglevel = google::GLOG_FATAL;
    return true;
  }();
  static_cast<void>(quiet);
}

ceres::Solver::Options SolverOptions(const RefineOptions& options) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = options.cost_tolerance;
  solver.parameter_tolerance = options.step_tolerance;
  // Absolute, so it would mean something else for every problem: the other two decide.
  solver.gradient_tolerance = 0;
  // At a border of failures a step is halved as often, each time for one evaluation; then the trust region shrinks.
  solver.max_num_line_search_step_size_iterations = 10;
  // Cubic interpolation would ask for a Jacobian at every step tried at a bound.
  solver.line_search_interpolation_type = ceres::QUADRATIC;
  solver.logging_type = ceres::SILENT;
  return solver;
}

// Steps refused until they are too short to count are no convergence.
RefineEnd EndOf(ceres::TerminationType type, bool refused, const EndOfRun& end) {
  if (end.end() != RefineEnd::kNotRun) return end.end();
  switch (type) {
    case ceres::CONVERGENCE: return refused ? RefineEnd::kFailed : RefineEnd::kConverged;
    case ceres::NO_CONVERGENCE: return RefineEnd::kIterations;
    case ceres::USER_SUCCESS: return RefineEnd::kStopped;
    default: return RefineEnd::kFailed;
  }
}

// Moves x to the optimum.
ceres::Solver::Summary Solve(ResidualFunction& function, const FitVariables& variables, const RefineOptions& options,
                             EndOfRun& end, Eigen::VectorXd& x) {
  QuietGlog();
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&function, nullptr, x.data());
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    problem.SetParameterLowerBound(x.data(), static_cast<int>(j), variables.lower()[j]);
    problem.SetParameterUpperBound(x.data(), static_cast<int>(j), variables.upper()[j]);
  }
  ceres::Solver::Options solver = SolverOptions(options);
  solver.callbacks.push_back(&end);
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  return summary;
}

}  // namespace

void RefineOptions::Validate() const {
  RequireOption(max_iterations >= 0, "max_iterations", max_iterations, "0 or more");
  RequireOption(step >= 0 && step <= 0.1, "step", step, "in [0, 0.1]");
  RequireOption(cost_tolerance > 0 && cost_tolerance < 1, "cost_tolerance", cost_tolerance, "in (0, 1)");
  RequireOption(step_tolerance > 0 && step_tolerance < 1, "step_tolerance", step_tolerance, "in (0, 1)");
  RequireOption(nearness >= 0 && nearness < 1, "nearness", nearness, "in [0, 1)");
  RequireOption(agreement > 0 && agreement < 1, "agreement", agreement, "in (0, 1)");
}

std::string_view RefineEndName(RefineEnd end) {
  switch (end) {
    case RefineEnd::kNotRun: return "not run";
    case RefineEnd::kConverged: return "converged";
    case RefineEnd::kIterations: return "iterations used up";
    case RefineEnd::kStartFailed: return "start could not be evaluated";
    case RefineEnd::kFailed: return "ended by failed evaluations";
    case RefineEnd::kStopped: return "stopped by the user";
    case RefineEnd::kGivenUp: return "given up";
    case RefineEnd::kKnown: return "met an optimum of another start";
  }
  return "unknown";
}

namespace {

// From where the function is, which it moves to the optimum, or as far as it comes.
void Go(ResidualFunction& function, const FitVariables& variables, const RefineOptions& options,
        const std::function<bool()>& stop, const KnownOptima& known, RefineResult& result) {
  Eigen::VectorXd x = function.x();
  EndOfRun end(stop, options, known, function);
  const ceres::Solver::Summary summary = Solve(function, variables, options, end, x);
  result.end = EndOf(summary.termination_type, !function.failure().empty(), end);
  result.met = end.met();
  const bool refused = result.end == RefineEnd::kFailed && !function.failure().empty();
  result.message = refused ? function.failure() : summary.message;
  if (end.end() == RefineEnd::kConverged)
    result.message =
        "No parameter is further than " + FormatNumber(options.nearness) + " standard deviations from its optimum.";
  result.iterations += std::max(0, static_cast<int>(summary.iterations.size()) - 1);
  // Ceres takes a failure back to the start.
  if (summary.IsSolutionUsable()) {
    function.MoveTo(x);
  } else {
    function.MoveToBest();
  }
}

// From `here`, which it moves to the optimum.
RefineResult Descend(Archive& archive, const FitVariables& variables, const RefineOptions& options,
                     const std::function<bool()>& stop, const KnownOptima& known, Residuals& here) {
  RefineResult result;
  ResidualFunction function(archive, variables, options, here.x, here.residuals);
  Go(function, variables, options, stop, known, result);
  const auto has_ended_itself = [&] { return result.end == RefineEnd::kConverged || result.end == RefineEnd::kFailed; };
  // Where forward differences see no way down there may be one.
  if (has_ended_itself() && function.is_far()) {
    function.BeNear();
    RefineOptions rest = options;
    rest.max_iterations -= result.iterations;
    Go(function, variables, rest, stop, known, result);
  }
  // A run that was ended on its way is no optimum, whose derivatives would count.
  const bool is_on_its_way =
      result.end == RefineEnd::kStopped || result.end == RefineEnd::kGivenUp || result.end == RefineEnd::kKnown;
  const bool may_be_blunt = function.is_far() && is_on_its_way;
  if (function.Linearise(may_be_blunt ? Differences::kForward : options.differences))
    result.jacobian = function.jacobian();
  here = {function.x(), function.residuals()};
  result.values = variables.ToValues(here.x);
  result.residuals = here.residuals;
  result.cost = options.loss.Cost(here.residuals);
  return result;
}

/// Of the cost: a loss that leads need not end in its own optimum, only in the right valley.
constexpr double kLeadingTolerance = 1e-4;

/// The loss that leads to the one of the options; nothing where that one does itself. Huber's is convex in the
/// residuals and leads to those that are not.
std::optional<RobustLoss> Leading(const RefineOptions& options, const Eigen::VectorXd& residuals) {
  const bool most_are_outliers = 2 * (residuals.array().abs() > options.loss.scale()).count() > residuals.size();
  if (!most_are_outliers) return std::nullopt;
  switch (options.loss.kind()) {
    case LossKind::kNone: return std::nullopt;
    case LossKind::kHuber:
    case LossKind::kSoftL1: return options.loss.As(LossKind::kNone);
    case LossKind::kCauchy:
    case LossKind::kTukey: return options.loss.As(LossKind::kHuber);
  }
  return std::nullopt;
}

}  // namespace

RefineResult Refine(Archive& archive, const Eigen::VectorXd& start, const RefineOptions& options,
                    const std::function<bool()>& stop, const KnownOptima& known, const Evaluation* at_start) {
  options.Validate();
  const FitVariables variables(archive.lattice());
  const std::int64_t paid_before = archive.counts().paid;
  Residuals here = {.x = variables.FromValues(start)};
  const Evaluation first = at_start ? *at_start : archive.EvaluateValues({variables.ToValues(here.x)}).front();
  if (!first.ok())
    return {.end = RefineEnd::kStartFailed,
            .message = first.detail,
            .values = start,
            .evaluations = archive.counts().paid - paid_before};
  here.residuals = first.residuals;
  RefineOptions rest = options;
  if (const std::optional<RobustLoss> leading = Leading(options, here.residuals)) {
    RefineOptions lead = options;
    lead.loss = *leading;
    lead.cost_tolerance = std::max(lead.cost_tolerance, kLeadingTolerance);
    Residuals led = here;
    rest.max_iterations -= Descend(archive, variables, lead, stop, {}, led).iterations;
    if (options.loss.Cost(led.residuals) < options.loss.Cost(here.residuals)) here = led;
  }
  RefineResult result = Descend(archive, variables, rest, stop, known, here);
  result.start_cost = options.loss.Cost(first.residuals);
  result.iterations += options.max_iterations - rest.max_iterations;
  result.evaluations = archive.counts().paid - paid_before;
  return result;
}

}  // namespace fourpost
