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

}  // namespace fourpost
