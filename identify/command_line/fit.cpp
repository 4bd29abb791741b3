#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/text_table.h"
#include "analysis/text/utf8.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/fit_progress.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/watch_page.h"
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

std::string IfKnown(double value, int digits) { return std::isfinite(value) ? Rounded(value, digits) : ""; }

/// "interrupted after step 2 (dry friction beside damper 'front'); the same command goes on there"
std::string InterruptedText(const GrownFit& grown) {
  if (grown.path.steps.empty()) return "interrupted before step 0 ended; the same command goes on";
  const std::vector<std::string> added = grown.path.Added();
  return "interrupted after step " + std::to_string(added.size()) + (added.empty() ? "" : " (" + added.back() + ")") +
         "; the same command goes on there";
}

/// "without dry friction beside damper 'front'"
std::string ChangeText(const GrowthStep& step) {
  if (step.IsOfStudy()) return "nothing";
  return (step.takes_back.empty() ? "" : "without ") + step.addition.words;
}

std::string KeptText(const GrowthPath& path, std::size_t place) {
  const GrowthStep& step = path.steps[place];
  if (!step.is_kept) return "no: " + step.reason;
  const std::optional<std::size_t> by = path.TakenBackBy(place);
  return by ? "taken back in step " + std::to_string(*by) : "yes";
}

/// The path of a fit that grew.
std::string GrowthText(const GrownFit& grown) {
  TextTable table({"step", "added", "misfit", "change of BIC", "validation rms error, %", "kept", "folder"});
  for (std::size_t i = 0; i < grown.path.steps.size(); ++i) {
    const GrowthStep& step = grown.path.steps[i];
    table.Add({std::to_string(grown.path.NumberOf(i)), ChangeText(step), IfKnown(step.misfit, 3),
               i == 0 ? "" : IfKnown(step.criterion, 4), IfKnown(step.validation_percent, 3), KeptText(grown.path, i),
               step.folder});
  }
  return (grown.path.steps.empty() ? "" : table.Format()) +
         (grown.is_interrupted ? "Growth was " + InterruptedText(grown) : "Growth ended: " + grown.path.end) + ".\n\n";
}

/// The line on the terminal and, on demand, a page, which begins with the first search: then the folder is that of a
/// run.
FitHooks Shown(const FitCommand& command, const FitOptions& options, std::optional<WatchPage>& page) {
  FitHooks hooks = ShownFit(options);
  if (!command.watch) return hooks;
  if (!page) {
    page.emplace(command.output, ValidUtf8(command.study.filename().string()));
    std::fprintf(stderr, "open %s to follow the fit\n", page->file().c_str());
  }
  page->Begin();
  hooks.progress = [show = std::move(hooks.progress), &page](const FitProgress& progress) {
    show(progress);
    page->Show(progress);
  };
  return hooks;
}

}  // namespace

int Run(const FitCommand& command) {
  WorkProgress progress;
  std::optional<WatchPage> page;
  const FitRunHooks hooks{.work = progress.Hooks(),
                          .find = [&progress](const Diagnostics& found) { progress.Tell(found); },
                          .begin = CatchInterrupts,
                          .fit = [&](const FitOptions& options) { return Shown(command, options, page); }};
  const GrownFit grown = command.grow ? GrowFit(command, hooks)
                                      : GrownFit{.path = {}, .fit = FitStudy(command, hooks), .folder = command.output};
  const FitRun& run = grown.fit;
  const FitResult& fit = run.fit;
  if (page) {
    const std::string report = (grown.folder / "report.html").lexically_relative(command.output).generic_string();
    page->End(run.is_written ? report : "", std::string(FitEndName(fit.end)));
  }
  if (!run.is_written) {
    Tell(fit.end == FitEnd::kInterrupted ? kFitInterrupted : kFitWithoutResults, {},
         {std::string(FitEndName(fit.end)), fit.message});
    return CodeOf(fit.end);
  }
  progress.End();
  if (command.json) Print(run.json);
  else PrintText((command.grow ? GrowthText(grown) : "") + run.text);
  std::fprintf(stderr, "results: %s; open %s\n", grown.folder.c_str(), (grown.folder / "report.html").c_str());
  if (grown.is_interrupted) std::fprintf(stderr, "growth was %s\n", InterruptedText(grown).c_str());
  if (grown.is_interrupted) return CodeOf(FitEnd::kInterrupted);
  return fit.end == FitEnd::kConverged && !run.verdict.explains() ? kNotGood : CodeOf(fit.end);
}

}  // namespace fourpost
