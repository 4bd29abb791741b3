#include "identify/compromise.h"

#include <cmath>
#include <utility>

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

}  // namespace

Problem CompromiseOf(Problem problem, std::vector<OutputResiduals> outputs) {
  Check(problem, outputs);
  Problem compromise = std::move(problem);
  const Eigen::Index count = compromise.residual_count;
  compromise.residual_count = CountOf(outputs);
  compromise.evaluate = [evaluate = std::move(compromise.evaluate), outputs = std::move(outputs),
                         count](const Eigen::VectorXd& values) {
    Evaluation evaluation = evaluate(values);
    if (!evaluation.ok()) return evaluation;
    if (evaluation.residuals.size() != count)
      return Failed(Failure::kWrongSize,
                    std::to_string(evaluation.residuals.size()) + " residuals in place of " + std::to_string(count));
    evaluation.residuals = Weighed(evaluation.residuals, outputs);
    return evaluation;
  };
  return compromise;
}

}  // namespace fourpost
