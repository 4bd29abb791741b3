#include "identify/refine/quasi_newton.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <ceres/ceres.h>

#include "identify/refine/fit_variables.h"

namespace fourpost {
namespace {

// x = middle + half_range sin(t).
class SineBounds {
 public:
  explicit SineBounds(const FitVariables& variables)
      : middle_(0.5 * (variables.lower() + variables.upper())),
        half_range_(0.5 * (variables.upper() - variables.lower())) {}

  // A start at a bound would have no slope: it is moved inside by 1e-4 of the range.
  Eigen::VectorXd ToAngle(const Eigen::VectorXd& x) const {
    const Eigen::ArrayXd share = ((x - middle_).array() / half_range_.array()).cwiseMax(-0.9998).cwiseMin(0.9998);
    return share.asin();
  }
  Eigen::VectorXd ToX(const Eigen::VectorXd& angle) const {
    return middle_.array() + half_range_.array() * angle.array().sin();
  }
  Eigen::VectorXd Slopes(const Eigen::VectorXd& angle) const { return half_range_.array() * angle.array().cos(); }

 private:
  Eigen::VectorXd middle_;
  Eigen::VectorXd half_range_;
};

class CostFunction : public ceres::FirstOrderFunction {
 public:
  CostFunction(Archive& archive, const FitVariables& variables, const RefineOptions& options)
      : archive_(archive), variables_(variables), bounds_(variables), options_(options) {}

  const SineBounds& bounds() const { return bounds_; }

  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    const Eigen::VectorXd angle = Eigen::Map<const Eigen::VectorXd>(parameters, variables_.size());
    const Eigen::VectorXd x = bounds_.ToX(angle);
    const Evaluation here = archive_.EvaluateValues({variables_.ToValues(x)}).front();
    if (!here.ok()) return false;
    *cost = here.cost();
    if (gradient == nullptr) return true;
    const auto jacobian = DifferenceJacobian(archive_, variables_, x, here.residuals,
                                             options_.DifferenceStep(archive_.problem()), options_.differences);
    if (!jacobian) return false;
    Eigen::Map<Eigen::VectorXd>(gradient, x.size()) =
        2 * (jacobian->transpose() * here.residuals).cwiseProduct(bounds_.Slopes(angle));
    return true;
  }

  int NumParameters() const override { return static_cast<int>(variables_.size()); }

 private:
  Archive& archive_;
  const FitVariables& variables_;
  SineBounds bounds_;
  const RefineOptions& options_;
};

class AskToStop : public ceres::IterationCallback {
 public:
  explicit AskToStop(const std::function<bool()>& stop) : stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return stop_ && stop_() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const std::function<bool()>& stop_;
};

RefineEnd EndOf(ceres::TerminationType type) {
  switch (type) {
    case ceres::CONVERGENCE: return RefineEnd::kConverged;
    case ceres::NO_CONVERGENCE: return RefineEnd::kIterations;
    case ceres::USER_SUCCESS: return RefineEnd::kStopped;
    default: return RefineEnd::kFailed;
  }
}

}  // namespace

RefineResult MinimiseQuasiNewton(Archive& archive, const Eigen::VectorXd& start, const RefineOptions& options,
                                 const std::function<bool()>& stop) {
  options.Validate();
  const FitVariables variables(archive.lattice());
  const std::int64_t paid_before = archive.counts().paid;
  auto* const function = new CostFunction(archive, variables, options);
  const SineBounds bounds = function->bounds();
  // Owns the function.
  const ceres::GradientProblem problem(function);
  Eigen::VectorXd angle = bounds.ToAngle(variables.FromValues(start));

  ceres::GradientProblemSolver::Options solver;
  solver.line_search_direction_type = ceres::BFGS;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = options.cost_tolerance;
  solver.parameter_tolerance = options.step_tolerance;
  solver.gradient_tolerance = 0;
  solver.logging_type = ceres::SILENT;
  AskToStop callback(stop);
  solver.callbacks.push_back(&callback);
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(solver, problem, angle.data(), &summary);

  RefineResult result;
  result.end = summary.iterations.empty() ? RefineEnd::kStartFailed : EndOf(summary.termination_type);
  result.message = summary.message;
  result.values = variables.ToValues(bounds.ToX(angle));
  result.start_cost = summary.initial_cost;
  result.cost = summary.final_cost;
  result.iterations = std::max(0, static_cast<int>(summary.iterations.size()) - 1);
  result.evaluations = archive.counts().paid - paid_before;
  return result;
}

}  // namespace fourpost
