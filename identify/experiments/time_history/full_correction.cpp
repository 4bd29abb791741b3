#include "identify/experiments/time_history/full_correction.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "identify/experiments/time_history/history_residuals.h"
#include "identify/experiments/time_history/history_simulation.h"

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

std::optional<std::vector<HistoryCheck>> CheckHistories(const Subject& subject,
                                                        const std::vector<MeasuredHistory>& histories, double error,
                                                        bool is_corrected, const std::vector<double>& values,
                                                        const HistorySolver::Progress& progress) {
  const Vehicle& vehicle = subject.vehicle();
  std::vector<HistoryCheck> checks;
  for (const MeasuredHistory& history : histories) {
    const std::optional<EngineHistory> answer =
        SimulateBy({.error = error, .visible = kNegligible}, history, vehicle, values, progress);
    if (!answer) return std::nullopt;
    HistoryCheck check{.by = answer->by};
    // One that was corrected stays so.
    if (is_corrected && answer->by.engine == Engine::kFull) {
      MeasuredHistory plain = history;
      plain.correction.resize(0, 0);
      const CondensedModel at_file = subject.Condensed()->At(history.setting.At(vehicle.ParameterValues()));
      const HistorySimulation reduced(plain, HistoryStep(plain, at_file, RigViewOf(vehicle), error));
      check.correction =
          answer->modelled - reduced.Run(subject.Condensed()->At(history.setting.At(values)), answer->released, {});
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

}  // namespace fourpost
