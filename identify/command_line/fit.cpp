#include <cstdio>
#include <memory>
#include <string>

#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/fit_progress.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/work_progress.h"
#include "identify/run/findings.h"

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

}  // namespace

int Run(const FitCommand& command) {
  WorkProgress progress;
  const FitRunHooks hooks{.work = progress.Hooks(),
                          .find = [&progress](const Diagnostics& found) { progress.Tell(found); },
                          .begin = CatchInterrupts,
                          .fit = [](const FitOptions& options) { return ShownFit(options); }};
  const FitRun run = FitStudy(command, hooks);
  const FitResult& fit = run.fit;
  if (!run.is_written) {
    Tell(fit.end == FitEnd::kInterrupted ? kFitInterrupted : kFitWithoutResults, {},
         {std::string(FitEndName(fit.end)), fit.message});
    return CodeOf(fit.end);
  }
  progress.End();
  if (command.json) Print(run.json);
  else PrintText(run.text);
  std::fprintf(stderr, "results: %s; open %s\n", command.output.c_str(), (command.output / "report.html").c_str());
  return fit.end == FitEnd::kConverged && !run.verdict.explains() ? kNotGood : CodeOf(fit.end);
}

}  // namespace fourpost
