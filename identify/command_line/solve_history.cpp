#include "identify/command_line/solve_history.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/text/progress_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/condensed_at_values.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/progress_line.h"
#include "vehicles/ride/findings.h"
#include "vehicles/ride/stability.h"

namespace fourpost {
namespace {

/// A history has a start: it can be drawn all the same.
void WarnOfGrowth(const Vehicle& vehicle, const CondensedModel& model, Diagnostics& findings) {
  if (const std::optional<Growth> growth = GrowthOf(vehicle, model))
    findings.Report(kUnstableInDesignPose, {vehicle.file}, {growth->Text()});
}

/// Shows what is run and how far it is; of further runs, at half the step, which it is.
class HistoryProgress {
 public:
  explicit HistoryProgress(const Drive& drive) : drive_(drive) {}

  /// Whether to go on.
  bool At(const std::string& work, double t) {
    if (work != work_ || t < last_) {
      run_ = work == work_ ? run_ + 1 : 1;
      work_ = work;
      began_s_ = line_.seconds();
    }
    last_ = t;
    const double start = drive_.start_s - drive_.lead_s;
    const double seconds = line_.seconds() - began_s_;
    const std::string left = TimeLeft((t - start) / (drive_.end_s - start), seconds);
    // How many runs it takes is known when two of them agree; each takes twice as long as the one before.
    line_.Show("simulate: " + work_ + ", " + Rounded(std::max(0.0, t), 3) + " of " + Rounded(drive_.end_s, 3) + " s" +
               (left.empty() ? ", run " : left + " of run ") + std::to_string(run_) + " of at most " +
               std::to_string(HistorySolver::MostRuns(work_)) +
               Rate(t - start, seconds, "simulated s"));
    return !Interrupted();
  }

 private:
  const Drive& drive_;
  ProgressLine line_;
  double last_ = -HUGE_VAL;
  std::string work_;
  int run_ = 1;
  double began_s_ = 0;
};

/// Takes the last readings, which are so many, away.
Eigen::MatrixXd TakeLast(std::size_t count, TimeHistory& history) {
  const auto probes = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd last = history.readings.rightCols(probes);
  history.readings.conservativeResize(Eigen::NoChange, history.readings.cols() - probes);
  return last;
}

}  // namespace

AnsweredHistory SolveHistory(const SimulateCommand& command, const Vehicle& vehicle, const Drive& drive,
                             Diagnostics& findings) {
  Vehicle probed = vehicle;
  const std::vector<std::size_t> rubbing = RubbingDampers(vehicle);
  const std::vector<std::size_t> linear = LinearTyres(vehicle);
  for (Sensor& sensor : ExtensionSensors(vehicle, rubbing)) probed.sensors.push_back(std::move(sensor));
  for (Sensor& sensor : ForceSensors(vehicle, linear)) probed.sensors.push_back(std::move(sensor));
  CondensedAtValues(probed);
  HistorySolver solver(probed);
  WarnOfGrowth(vehicle, solver.model(), findings);
  const TimeGrid grid{drive.start_s, drive.end_s, command.rate_Hz, drive.lead_s};
  HistoryProgress progress(drive);
  AnsweredHistory answered{
      .answer = solver.Solve(drive.motion, grid,
                             {.engine = command.engine, .error = command.error, .compared = vehicle.sensors.size()},
                             [&](const char* work, double t) { return progress.At(work, t); })};
  const Eigen::MatrixXd forces = TakeLast(linear.size(), answered.answer.history);
  const Eigen::MatrixXd extensions = TakeLast(rubbing.size(), answered.answer.history);
  const Eigen::Index lead = std::min(grid.lead_count(), forces.rows());
  answered.pulls = FindTyrePulls(vehicle, solver.model().preloads.tyre, forces.bottomRows(forces.rows() - lead));
  if (!answered.answer.ended) answered.locked = FindLockedFriction(vehicle, extensions, command.rate_Hz);
  return answered;
}

}  // namespace fourpost
