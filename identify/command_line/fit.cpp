#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/fit_progress.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/work_progress.h"
#include "identify/run/findings.h"
#include "identify/run/grown_fit.h"

namespace fourpost {
namespace {

int CodeOf(FitEnd end) {
  switch (end) {
    case FitEnd::kConverged: return kGood;
    case FitEnd::kAllFailed: return kAllSimulationsFailed;
    case FitEnd::kInterrupted: return kInterrupted;
    case FitEnd::kUnidentified: return kUnreadableInput;
    case FitEnd::kNotRun:
    case FitEnd::kNotConverged: return kNotGood;
  }
  return kNotGood;
}

/// The path of a fit that grew.
std::string GrowthText(const GrownFit& grown) {
  TextTable table({"step", "added", "misfit", "change of BIC", "validation error, %", "kept"});
  for (std::size_t i = 0; i < grown.steps.size(); ++i) {
    const GrowthStep& step = grown.steps[i];
    table.Add({std::to_string(i), step.added.empty() ? "nothing" : step.added, Rounded(step.misfit, 3),
               i == 0 ? "" : Rounded(step.criterion, 4),
               std::isfinite(step.validation_percent) ? Rounded(step.validation_percent, 3) : "",
               step.is_kept ? "yes" : "no: " + step.reason});
  }
  return table.Format() + "Growth ended: " + grown.end + ".\n\n";
}

}  // namespace

int Run(const FitCommand& command) {
  WorkProgress progress;
  const FitRunHooks hooks{.work = progress.Hooks(),
                          .find = [&progress](const Diagnostics& found) { progress.Tell(found); },
                          .begin = CatchInterrupts,
                          .fit = [](const FitOptions& options) { return ShownFit(options); }};
  const GrownFit grown = command.grow
                             ? GrowFit(command, hooks)
                             : GrownFit{.steps = {}, .fit = FitStudy(command, hooks), .folder = command.output};
  const FitRun& run = grown.fit;
  const FitResult& fit = run.fit;
  if (!run.is_written) {
    Tell(fit.end == FitEnd::kInterrupted ? kFitInterrupted : kFitWithoutResults, {},
         {std::string(FitEndName(fit.end)), fit.message});
    return CodeOf(fit.end);
  }
  progress.End();
  if (command.json) Print(run.json);
  else PrintText((command.grow ? GrowthText(grown) : "") + run.text);
  std::fprintf(stderr, "results: %s; open %s\n", grown.folder.c_str(), (grown.folder / "report.html").c_str());
  if (grown.is_interrupted) return CodeOf(FitEnd::kInterrupted);
  return fit.end == FitEnd::kConverged && !run.verdict.explains() ? kNotGood : CodeOf(fit.end);
}

}  // namespace fourpost
