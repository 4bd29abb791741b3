#include "identify/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/fit_variables.h"

namespace fourpost {
namespace {

/// Within this share of its range a parameter counts as being at the bound.
constexpr double kAtBound = 1e-6;

Eigen::VectorXd StartValues(const FourPostObjective& objective) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(objective.free().size()));
  for (std::size_t i = 0; i < objective.free().size(); ++i)
    values[static_cast<Eigen::Index>(i)] = objective.vehicle().parameters[objective.free()[i]].value;
  return values;
}

std::vector<FittedParameter> Describe(const FourPostObjective& objective, const Eigen::VectorXd& values,
                                      const Covariance& covariance) {
  std::vector<FittedParameter> out;
  for (std::size_t i = 0; i < objective.free().size(); ++i) {
    const Parameter& parameter = objective.vehicle().parameters[objective.free()[i]];
    const Eigen::Index k = static_cast<Eigen::Index>(i);
    const double range = parameter.upper - parameter.lower;
    FittedParameter fitted;
    fitted.name = parameter.name;
    fitted.start = parameter.value;
    fitted.value = values[k];
    fitted.lower = parameter.lower;
    fitted.upper = parameter.upper;
    fitted.sd = covariance.sd.size() > k ? covariance.sd[k] : std::numeric_limits<double>::infinity();
    fitted.at_bound = values[k] - parameter.lower < kAtBound * range || parameter.upper - values[k] < kAtBound * range;
    fitted.dimension = parameter.dimension;
    fitted.unit = parameter.unit;
    out.push_back(fitted);
  }
  return out;
}

std::string FailureCauses(const EvaluationCounts& counts) {
  std::string text = "every evaluation failed:";
  for (const auto& [cause, tally] : counts.failures)
    text += " " + std::to_string(tally.count) + " " + std::string(FailureName(cause)) + " (" + tally.example + ");";
  return text;
}

FitEnd EndOf(const RefineResult& best, bool interrupted) {
  if (interrupted) return FitEnd::kInterrupted;
  return best.end == RefineEnd::kConverged ? FitEnd::kConverged : FitEnd::kNotConverged;
}

void Report(const FitHooks& hooks, std::string_view stage, double best_cost, const EvaluationCounts& counts) {
  if (hooks.progress) hooks.progress({stage, best_cost, counts.paid, counts.reused, counts.failed()});
}

}  // namespace

std::string_view FitEndName(FitEnd end) {
  switch (end) {
    case FitEnd::kNotRun: return "not_run";
    case FitEnd::kConverged: return "converged";
    case FitEnd::kNotConverged: return "not_converged";
    case FitEnd::kInterrupted: return "interrupted";
    case FitEnd::kAllFailed: return "all_failed";
  }
  return "";
}

FitResult Fit(const FourPostObjective& objective, const FitOptions& options, const FitHooks& hooks) {
  Archive archive(objective.MakeProblem(), options.threads);
  const std::function<bool()> stop = hooks.stop ? hooks.stop : [] { return false; };

  FitResult result;
  result.search = SearchDvhde(
      archive, options.search,
      {[&](const SearchGeneration& generation) { Report(hooks, "search", generation.best_cost, archive.counts()); },
       stop});
  result.evaluations = archive.counts();
  if (result.search.candidates.empty()) {
    result.end = stop() ? FitEnd::kInterrupted : FitEnd::kAllFailed;
    result.message = FailureCauses(archive.counts());
    result.values = objective.vehicle().ParameterValues();
    return result;
  }

  std::vector<Eigen::VectorXd> starts;
  for (const Candidate& candidate : result.search.candidates)
    if (static_cast<int>(starts.size()) < options.starts) starts.push_back(candidate.values);
  starts.push_back(StartValues(objective));
  const auto tell_and_ask = [&] {
    Report(hooks, "refine", result.search.candidates.front().cost, archive.counts());
    return stop();
  };
  const MultiStartResult refined = RefineFrom(archive, starts, options.refine, tell_and_ask);
  result.evaluations = archive.counts();
  result.starts = static_cast<int>(refined.runs.size());
  result.agreeing = refined.agreeing;

  Eigen::VectorXd values = result.search.candidates.front().values;
  result.cost = result.search.candidates.front().cost;
  result.end = FitEnd::kInterrupted;
  if (refined.best >= 0) {
    const RefineResult& best = refined.runs[static_cast<std::size_t>(refined.best)];
    values = best.values;
    result.cost = best.cost;
    result.residual_count = best.residuals.size();
    result.end = EndOf(best, stop());
    result.message = best.message;
    if (best.jacobian.size() > 0)
      result.covariance = EstimateCovariance(best.jacobian, FitVariables(archive.lattice()).Slopes(values), best.cost);
  }
  result.parameters = Describe(objective, values, result.covariance);
  result.values = objective.AllParameters(values);
  return result;
}

}  // namespace fourpost
