#include "identify/comparison/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "analysis/process/thread_time.h"
#include "analysis/signals/median.h"
#include "analysis/text/option_check.h"
#include "identify/search/parallel.h"

namespace fourpost {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// What a run leaves behind.
struct FinishedRun {
  SearchEnd end = SearchEnd::kNotRun;
  std::vector<Improvement> improvements;
  SearchGain accelerations;
  SearchGain migrations;
  std::int64_t paid = 0;
  double seconds = 0;

  double cost() const { return improvements.empty() ? kInfinite : improvements.back().cost; }
};

FinishedRun RunOnce(const Problem& problem, const ComparedMethod& method, std::uint64_t seed, const StopRules& rules,
                    const std::function<bool()>& stop, EvaluationStore* store) {
  const double start_s = ThreadTime_s();
  Archive archive(problem, 1, store, Repeats::kPaid);
  FinishedRun run;
  if (method.foreign) {
    run.end = method.foreign->run(archive, seed, rules, stop);
  } else {
    const SearchResult result = RunMethod(method.options, archive, seed, rules, {.count = 1}, {.stop = stop});
    run.end = result.end;
    run.accelerations = result.accelerations;
    run.migrations = result.migrations;
  }
  run.improvements = archive.improvements();
  run.paid = archive.counts().paid;
  run.seconds = store ? std::numeric_limits<double>::quiet_NaN() : ThreadTime_s() - start_s;
  return run;
}

RunOutcome OutcomeOf(const FinishedRun& run, double target) {
  const auto reached = std::find_if(run.improvements.begin(), run.improvements.end(),
                                    [&](const Improvement& improvement) { return improvement.cost <= target; });
  const bool solved = reached != run.improvements.end();
  const std::int64_t evaluations = solved ? reached->paid : run.paid;
  const double share = run.paid > 0 ? static_cast<double>(evaluations) / static_cast<double>(run.paid) : 1;
  return {.evaluations = evaluations, .solved = solved, .cost = run.cost(), .seconds = share * run.seconds};
}

double ExpectedEvaluations(double evaluations, std::int64_t successes) {
  return successes > 0 ? evaluations / static_cast<double>(successes) : kInfinite;
}

Interval BootstrapExpected(const std::vector<RunOutcome>& outcomes) {
  constexpr std::size_t kSamples = 2000;
  const auto last = static_cast<std::int64_t>(outcomes.size()) - 1;
  std::vector<double> expected;
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    Draws draws(0, DrawPurpose::kBootstrap, 0, sample);
    double evaluations = 0;
    std::int64_t successes = 0;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const RunOutcome& outcome = outcomes[static_cast<std::size_t>(draws.Integer(0, last))];
      evaluations += static_cast<double>(outcome.evaluations);
      successes += outcome.solved;
    }
    expected.push_back(ExpectedEvaluations(evaluations, successes));
  }
  std::sort(expected.begin(), expected.end());
  return {expected[kSamples / 40], expected[kSamples - 1 - kSamples / 40]};
}

std::vector<std::pair<std::string, std::string>> SettingsOf(const ComparedMethod& method) {
  return method.foreign ? method.foreign->settings : Settings(method.options);
}

MethodSummary Summarise(const ComparedMethod& method, const std::vector<FinishedRun>& runs, double target) {
  MethodSummary summary = {.name = method.name,
                           .algorithm = method.foreign ? "" : std::string(AlgorithmName(method.options)),
                           .settings = SettingsOf(method)};
  std::vector<double> costs;
  double evaluations = 0;
  for (const FinishedRun& run : runs) {
    summary.outcomes.push_back(OutcomeOf(run, target));
    ++summary.ends[run.end];
    summary.accelerations += run.accelerations;
    summary.migrations += run.migrations;
    summary.successes += summary.outcomes.back().solved;
    evaluations += static_cast<double>(summary.outcomes.back().evaluations);
    costs.push_back(run.cost());
  }
  if (runs.empty()) return summary;
  const auto count = static_cast<std::int64_t>(runs.size());
  summary.success_share = WilsonInterval(summary.successes, count);
  summary.evaluations_mean = evaluations / static_cast<double>(count);
  summary.expected_evaluations = ExpectedEvaluations(evaluations, summary.successes);
  summary.expected_interval = BootstrapExpected(summary.outcomes);
  summary.cost_worst = *std::max_element(costs.begin(), costs.end());
  summary.cost_median = Median(std::move(costs));
  return summary;
}

double BestOf(const std::vector<std::vector<FinishedRun>>& runs) {
  double best = kInfinite;
  for (const auto& of_method : runs)
    for (const FinishedRun& run : of_method) best = std::min(best, run.cost());
  return best;
}

}  // namespace

void ComparisonOptions::Validate() const {
  RequireOption(runs >= 1, "runs", runs, "1 or more");
  RequireOption(near_best > 0 && near_best <= 1, "near_best", near_best, "in (0, 1]");
  rules.Validate();
}

double MethodSummary::MeanSeconds() const {
  double sum = 0;
  for (const RunOutcome& outcome : outcomes) sum += outcome.seconds;
  return sum / static_cast<double>(outcomes.size());
}

Interval WilsonInterval(std::int64_t successes, std::int64_t runs) {
  constexpr double kQuantile = 1.959963984540054;
  const auto n = static_cast<double>(runs);
  const double share = static_cast<double>(successes) / n;
  const double z2 = kQuantile * kQuantile / n;
  const double middle = (share + z2 / 2) / (1 + z2);
  const double half = kQuantile / (1 + z2) * std::sqrt(share * (1 - share) / n + z2 / (4 * n));
  // Exact at both ends, where rounding would leave some 1e-16.
  return {successes == 0 ? 0 : middle - half, successes == runs ? 1 : middle + half};
}

Comparison Compare(const Problem& problem, const std::vector<ComparedMethod>& methods, const ComparisonOptions& options,
                   const ComparisonHooks& hooks, EvaluationStore* store) {
  options.Validate();
  for (const ComparedMethod& method : methods)
    if (!method.foreign) Validate(method.options);
  const auto runs = static_cast<std::size_t>(options.runs);
  std::vector<std::vector<FinishedRun>> finished(methods.size(), std::vector<FinishedRun>(runs));
  std::mutex mutex;
  std::int64_t done = 0;
  ForEachInParallel(methods.size() * runs, ThreadCount(options.threads), [&](std::size_t task) {
    const std::size_t method = task % methods.size();
    const std::size_t run = task / methods.size();
    if (hooks.stop && hooks.stop()) return;
    finished[method][run] = RunOnce(problem, methods[method], options.seed + run, options.rules, hooks.stop, store);
    const std::lock_guard lock(mutex);
    if (hooks.progress) hooks.progress(++done, static_cast<std::int64_t>(methods.size() * runs));
  });

  Comparison comparison{.parameters = problem.lattice.size(),
                        .residuals = static_cast<std::size_t>(problem.residual_count)};
  for (auto& of_method : finished) {
    const auto unfinished = [](const FinishedRun& run) {
      return run.end == SearchEnd::kNotRun || run.end == SearchEnd::kStopped;
    };
    comparison.interrupted |= std::erase_if(of_method, unfinished) > 0;
  }
  comparison.target_cost = options.rules.target_cost.value_or((1 + options.near_best) * BestOf(finished));
  for (std::size_t m = 0; m < methods.size(); ++m)
    comparison.methods.push_back(Summarise(methods[m], finished[m], comparison.target_cost));
  return comparison;
}

}  // namespace fourpost
