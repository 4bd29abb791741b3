#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <optional>

#include "analysis/text/number.h"
#include "analysis/text/progress_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/comparison/comparison.h"
#include "identify/comparison/comparison_json.h"
#include "identify/report/methods_page.h"
#include "identify/search/evaluation_store.h"
#include "identify/search/idle_parameters.h"
#include "identify/study/study_methods.h"
#include "identify/study/study_problem.h"
#include "vehicles/requests/option_quantity.h"

namespace fourpost {
namespace {

void CheckEffectsOrThrow(const Study& study, const Problem& problem, EvaluationStore* store) {
  Archive archive(problem, 1, store);
  Diagnostics diagnostics;
  CheckEffects(archive, study.file.string(), diagnostics);
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  Tell(diagnostics);
}

std::vector<ComparedMethod> MethodsOrThrow(const Study& study, const std::vector<std::string>& names,
                                           const Problem& problem) {
  Diagnostics diagnostics;
  std::vector<ComparedMethod> methods = MethodsOf(study, names, problem, diagnostics);
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return methods;
}

Comparison CompareWithProgress(const Problem& problem, const std::vector<ComparedMethod>& methods,
                               const ComparisonOptions& options, EvaluationStore* store) {
  CatchInterrupts();
  ProgressLine line;
  ComparisonHooks hooks;
  hooks.progress = [&](std::int64_t done, std::int64_t total) {
    const auto runs = static_cast<double>(done);
    const double seconds = line.seconds();
    line.Show("compare: " + std::to_string(done) + " of " + std::to_string(total) + " runs" +
              TimeLeft(runs / static_cast<double>(total), seconds) + Rate(runs, seconds, "runs"));
  };
  hooks.stop = Interrupted;
  return Compare(problem, methods, options, hooks, store);
}

std::string Range(const Interval& interval, int digits) {
  return Rounded(interval.lower, digits) + " .. " + Rounded(interval.upper, digits);
}

std::string Table(const Comparison& comparison, bool time) {
  std::vector<std::string> head = {"method",      "runs", "solved",      "95 %",      "evaluations",
                                   "per success", "95 %", "median cost", "worst cost"};
  if (time) head.push_back("seconds");
  TextTable table(head);
  for (const MethodSummary& method : comparison.methods) {
    const auto runs = static_cast<double>(method.outcomes.size());
    const Interval percent = {100 * method.success_share.lower, 100 * method.success_share.upper};
    std::vector<std::string> row = {method.name,
                                    std::to_string(method.outcomes.size()),
                                    Rounded(100 * static_cast<double>(method.successes) / runs, 3) + " %",
                                    Range(percent, 3) + " %",
                                    Rounded(method.evaluations_mean, 4),
                                    Rounded(method.expected_evaluations, 4),
                                    Range(method.expected_interval, 4),
                                    Rounded(method.cost_median, 5),
                                    Rounded(method.cost_worst, 5)};
    if (time) row.push_back(Rounded(method.MeanSeconds(), 3));
    table.Add(row);
  }
  return table.Format();
}

std::string Rule(const Comparison& comparison, const ComparisonOptions& options) {
  std::string text = "Solved: cost " + FormatNumber(comparison.target_cost) + " or less";
  if (!options.rules.target_cost) text += ", " + Rounded(100 * options.near_best, 2) + " % above the best of all runs";
  return text + "; at most " + std::to_string(options.rules.max_evaluations) + " evaluations a run; seeds from " +
         std::to_string(options.seed) + ".";
}

std::string GainText(const std::string& what, const SearchGain& gain) {
  if (gain.count == 0) return "";
  return ", " + std::to_string(gain.count) + " " + what + (gain.count == 1 ? "" : "s") + " (" +
         std::to_string(gain.successes) + " with a lower cost)";
}

std::string Details(const Comparison& comparison, const ComparisonOptions& options) {
  std::string text = Rule(comparison, options) + '\n';
  for (const MethodSummary& method : comparison.methods) {
    text += method.name + ": ended by";
    for (const auto& [end, count] : method.ends)
      text += " " + std::string(SearchEndName(end)) + " (" + std::to_string(count) + ")";
    text += "; algorithm " + method.algorithm + GainText("acceleration", method.accelerations) +
            GainText("migration", method.migrations) + "; with";
    for (const auto& [key, value] : method.settings) text += " " + key + " " + value;
    text += "\n";
  }
  return text;
}

/// Throws FaultyInput.
double ShareOrThrow(const std::string& text) {
  Diagnostics diagnostics;
  const std::optional<double> share = ReadShare(text, "--near", diagnostics);
  if (!share) throw FaultyInput(diagnostics);
  return *share;
}

}  // namespace

int Run(const CompareCommand& command) {
  RequireWritable(command.output, {command.study, command.archive});
  RequireEnding("--output", command.output, "a page", ".html");
  const Study study = ReadStudyOrThrow(command.study);
  StudyProblem loaded;
  LoadProblem(study, loaded);
  Tell(loaded.findings);
  const Problem& problem = *loaded.problem;
  const std::vector<ComparedMethod> methods = MethodsOrThrow(study, command.methods, problem);
  std::optional<EvaluationStore> opened;
  if (!command.archive.empty()) opened.emplace(command.archive, loaded.context);
  EvaluationStore* const store = opened ? &*opened : nullptr;
  CheckEffectsOrThrow(study, problem, store);

  ComparisonOptions options;
  if (!command.near_best.empty()) options.near_best = ShareOrThrow(command.near_best);
  options.runs = command.runs;
  options.seed = command.seed;
  options.threads = command.threads;
  options.rules.target_cost = loaded.target_cost;
  options.rules.max_evaluations = command.evaluations.value_or(study.search.evaluations.value_or(3000));
  options.rules.max_generations = study.search.generations;
  options.rules.max_stagnant_generations = study.search.stagnation;
  options.rules.max_seconds = study.search.time_s;
  const Comparison comparison = CompareWithProgress(problem, methods, options, store);
  const bool nothing_succeeded = !std::isfinite(comparison.target_cost);
  if (!command.output.empty()) {
    ReplaceFile(command.output,
                MethodsPage(comparison, command.study.stem().string(), Rule(comparison, options), command.time));
    std::fprintf(stderr, "results: %s\n", command.output.c_str());
  }
  if (command.json) Print(ComparisonJson(comparison, command.study.string(), command.seed, command.time));
  else PrintText(Table(comparison, command.time) + '\n' + Details(comparison, options));
  if (comparison.interrupted) return kInterrupted;
  return nothing_succeeded ? kAllSimulationsFailed : kGood;
}

}  // namespace fourpost
