#include "identify/run/growth_judgement.h"

#include <algorithm>
#include <cmath>

#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

/// By this share validation recordings may be predicted worse by chance; better by this one is more than chance.
constexpr double kWorse = 0.02;
constexpr double kBetter = 0.01;

std::string ReasonAgainst(const GrowthStep& before, const GrowthStep& step) {
  const double error = step.validation_percent / before.validation_percent;
  if (!(step.criterion < 0)) return "the criterion does not fall";
  if (!step.at_bound.empty()) return "its " + step.at_bound.front() + " ends at a bound";
  if (error > 1 + kWorse) return "validation recordings are predicted worse";
  if (step.takes_back.empty() && before.misfit <= 1 && HasValidation(before) && !(error < 1 - kBetter))
    return "validation recordings are predicted no better";
  return "";
}

}  // namespace

double ValidationPercent(const nlohmann::json& result) {
  double squares = 0;
  int count = 0;
  for (const nlohmann::json& channel : ListAt(result, "validation")) {
    const double percent = NumberAt(channel, "nmse_percent");
    if (!std::isfinite(percent)) continue;
    squares += percent / 100;
    ++count;
  }
  return count > 0 ? 100 * std::sqrt(squares / count) : std::nan("");
}

std::vector<std::string> AtBound(const FitResult& fit, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const FittedParameter& one : fit.parameters)
    if (one.at_bound && std::find(names.begin(), names.end(), one.name) != names.end()) found.push_back(one.name);
  return found;
}

bool HasValidation(const GrowthStep& step) { return std::isfinite(step.validation_percent); }

void Judge(const GrowthStep& before, GrowthStep& step) {
  step.reason = ReasonAgainst(before, step);
  step.is_kept = step.reason.empty();
}

std::optional<std::size_t> BestThatStoodBack(const GrowthPath& path) {
  const std::size_t last = path.LastKept();
  const GrowthStep& before = path.steps[last];
  std::optional<std::size_t> best;
  bool is_best_worse = false;
  for (std::size_t i = last + 1; i < path.steps.size(); ++i) {
    GrowthStep step = path.steps[i];
    if (!std::isfinite(step.cost) || !step.takes_back.empty()) continue;
    step.at_bound.clear();
    Judge(before, step);
    const bool is_worse = !step.is_kept;
    if (is_worse && !(step.criterion < 0 && before.misfit > 1)) continue;
    // A worse prediction weighs more than a bound.
    if (best && (is_worse != is_best_worse ? is_worse : !(step.criterion < path.steps[*best].criterion))) continue;
    best = i;
    is_best_worse = is_worse;
  }
  return best;
}

std::size_t BestPredicted(const GrowthPath& path) {
  const std::size_t last = path.LastKept();
  std::size_t best = last;
  for (std::size_t i = 0; i < last; ++i)
    if (path.steps[i].is_kept && path.steps[i].validation_percent < path.steps[best].validation_percent) best = i;
  const double allowed = (1 + kWorse) * path.steps[best].validation_percent;
  return path.steps[last].validation_percent > allowed ? best : last;
}

}  // namespace fourpost
