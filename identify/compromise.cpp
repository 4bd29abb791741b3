#include "identify/compromise.h"

#include <cmath>
#include <string>

#include "analysis/option_check.h"

namespace fourpost {
namespace {

void Check(const Problem& problem, const std::vector<OutputResiduals>& outputs) {
  for (const OutputResiduals& output : outputs) {
    RequireOption(output.first >= 0 && output.count > 0, "count", static_cast<double>(output.count),
                  "at least 1, from a residual on");
    RequireOption(output.first + output.count <= problem.residual_count, "first + count",
                  static_cast<double>(output.first + output.count), "no more than the problem has residuals");
    RequireOption(output.weight > 0 && std::isfinite(output.weight), "weight", output.weight, "positive and finite");
  }
}

Eigen::Index CountOf(const std::vector<OutputResiduals>& outputs) {
  Eigen::Index count = 0;
  for (const OutputResiduals& output : outputs) count += output.count;
  return count;
}

Eigen::VectorXd Weighed(const Eigen::VectorXd& residuals, const std::vector<OutputResiduals>& outputs) {
  Eigen::VectorXd weighed(CountOf(outputs));
  Eigen::Index at = 0;
  for (const OutputResiduals& output : outputs) {
    const auto own = residuals.segment(output.first, output.count);
    weighed.segment(at, output.count) = output.weight * own.norm() * own;
    at += output.count;
  }
  return weighed;
}

/// d (w |r| r) = w (|r| + r r' / |r|) dr.
Eigen::MatrixXd Weighed(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals,
                        const std::vector<OutputResiduals>& outputs) {
  Eigen::MatrixXd weighed = Eigen::MatrixXd::Zero(CountOf(outputs), jacobian.cols());
  Eigen::Index at = 0;
  for (const OutputResiduals& output : outputs) {
    const auto own = residuals.segment(output.first, output.count);
    const auto slopes = jacobian.middleRows(output.first, output.count);
    const double size = own.norm();
    auto rows = weighed.middleRows(at, output.count);
    if (size > 0) rows = output.weight * (size * slopes + own * (own.transpose() * slopes) / size);
    at += output.count;
  }
  return weighed;
}

}  // namespace

Problem CompromiseOf(const Problem& problem, const std::vector<OutputResiduals>& outputs) {
  Check(problem, outputs);
  Problem compromise = problem;
  compromise.residual_count = CountOf(outputs);
  compromise.evaluate = [problem, outputs](const Eigen::VectorXd& values, const Deadline& deadline) {
    Evaluation evaluation = problem.evaluate(values, deadline);
    if (!evaluation.ok()) return evaluation;
    if (evaluation.residuals.size() != problem.residual_count)
      return Failed(Failure::kWrongSize, std::to_string(evaluation.residuals.size()) + " residuals in place of " +
                                             std::to_string(problem.residual_count));
    evaluation.residuals = Weighed(evaluation.residuals, outputs);
    return evaluation;
  };
  if (problem.differentiate)
    compromise.differentiate = [problem, outputs](const Eigen::VectorXd& values) {
      return Weighed(problem.differentiate(values), problem.evaluate(values).residuals, outputs);
    };
  return compromise;
}

}  // namespace fourpost
