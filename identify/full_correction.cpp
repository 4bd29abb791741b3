#include "identify/full_correction.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "identify/history_residuals.h"
#include "identify/history_simulation.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of a signal's rms: what is left of the integration's error. Far less than shows is many standard deviations of a
/// parameter over thousands of samples.
constexpr double kNegligible = 1e-3;

double ChangeOf(const MeasuredHistory& history, const Eigen::MatrixXd& correction) {
  double largest = 0;
  for (Index i = 0; i < correction.cols(); ++i) {
    Eigen::VectorXd change = correction.col(i);
    if (history.correction.size() > 0) change -= history.correction.col(i);
    const double rms = std::sqrt(change.squaredNorm() / static_cast<double>(change.size()));
    largest = std::max(largest, rms / history.signals[static_cast<std::size_t>(i)].Deviation());
  }
  return largest;
}

}  // namespace

std::optional<std::vector<HistoryCheck>> CheckHistories(const LoadedStudy& study, const std::vector<double>& values,
                                                        const HistorySolver::Progress& progress) {
  if (study.histories.empty()) return std::vector<HistoryCheck>();
  const bool is_corrected = study.study.history_cost != HistoryCost::kPrediction;
  const HistoryResiduals::Options options = study.HistoryOptions();
  const auto condensed = std::make_shared<const CondensedVehicle>(study.vehicle);
  const CondensedModel model = condensed->At(values);
  const RigView rig = RigViewOf(study.vehicle);
  std::vector<HistoryCheck> checks;
  for (const MeasuredHistory& history : study.histories) {
    const std::optional<EngineHistory> answer =
        SimulateBy({.error = options.error, .visible = kNegligible}, history, study.vehicle, values, progress);
    if (!answer) return std::nullopt;
    HistoryCheck check{.by = answer->by};
    // One that was corrected stays so.
    if (is_corrected && answer->by.engine == Engine::kFull) {
      MeasuredHistory plain = history;
      plain.correction.resize(0, 0);
      const CondensedModel at_file = condensed->At(study.vehicle.ParameterValues());
      const HistorySimulation reduced(plain, HistoryStep(plain, at_file, rig, options.error));
      check.correction = answer->modelled - reduced.Run(model);
      check.change = ChangeOf(history, check.correction);
    } else {
      check.correction = history.correction;
      check.by.engine = Engine::kReduced;
    }
    if (history.correction.size() > 0) {
      check.by.engine = Engine::kFull;
      check.by.correction_change = check.change;
    }
    checks.push_back(std::move(check));
  }
  return checks;
}

bool IsCorrectionDue(const std::vector<HistoryCheck>& checks) {
  return std::any_of(checks.begin(), checks.end(),
                     [](const HistoryCheck& check) { return check.change > kNegligible; });
}

void Correct(const std::vector<HistoryCheck>& checks, LoadedStudy& study) {
  for (std::size_t h = 0; h < checks.size(); ++h) study.histories[h].correction = checks[h].correction;
}

FitResult GoneOn(const FitResult& first, FitResult second) {
  second.before = first.before;
  second.search = first.search;
  second.search_settings = first.search_settings;
  second.starts = first.starts;
  second.agreeing = first.agreeing;
  std::vector<RefinedStart> refined = first.refined;
  refined.insert(refined.end(), second.refined.begin(), second.refined.end());
  second.refined = std::move(refined);
  second.options = first.options;
  second.evaluations.paid += first.evaluations.paid;
  second.evaluations.reused += first.evaluations.reused;
  second.evaluations.restored += first.evaluations.restored;
  for (const auto& [cause, tally] : first.evaluations.failures) {
    FailureTally& sum = second.evaluations.failures[cause];
    if (sum.count == 0) sum.example = tally.example;
    sum.count += tally.count;
  }
  return second;
}

}  // namespace fourpost
