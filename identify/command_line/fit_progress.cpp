#include "identify/command_line/fit_progress.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "identify/command_line/interrupt.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/text_table.h"

namespace fourpost {
namespace {

std::string ProgressText(const FitProgress& progress, const FitOptions& options, double seconds) {
  const std::int64_t computed = progress.paid - progress.restored;
  const double rate = static_cast<double>(computed) / std::max(seconds, 1e-3);
  const std::int64_t search_evaluations = options.stop.max_evaluations;
  const RobustLoss& loss = options.refine.loss;
  std::string text = std::string(progress.stage) + ": ";
  std::string left;
  if (progress.stage == "search") {
    // The last generation is not cut short.
    const std::int64_t of_search = std::min(progress.in_stage, search_evaluations);
    text += std::to_string(of_search) + " of " + std::to_string(search_evaluations) + " evaluations, ";
    if (computed > 0)
      left = TimeLeft(static_cast<double>(of_search) / static_cast<double>(search_evaluations), seconds);
  }
  std::string best;
  if (std::isfinite(progress.best_cost))
    best = ", best cost " + Rounded(progress.best_cost, 5) +
           (loss.kind() == LossKind::kNone ? "" : " by " + std::string(loss.name()));
  return text + std::to_string(progress.paid) + " evaluations in all (" + std::to_string(progress.reused) +
         " reused, " + std::to_string(progress.failed) + " failed, " + std::to_string(progress.restored) +
         " from the archive), " + Rounded(rate, 3) + " per second" + best +
         (left.empty() ? "" : left + " of the search");
}

}  // namespace

FitResult FitWithProgress(const VehicleObjective& objective, const FitOptions& options, EvaluationStore& store) {
  ProgressLine line;
  FitHooks hooks;
  hooks.progress = [&](const FitProgress& progress) { line.Show(ProgressText(progress, options, line.seconds())); };
  hooks.stop = Interrupted;
  FitResult fit = Fit(objective, options, hooks, &store);
  if (!fit.parameters.empty()) line.ShowNext("the fit is done; what it foretells, and its report, are computed");
  return fit;
}

}  // namespace fourpost
