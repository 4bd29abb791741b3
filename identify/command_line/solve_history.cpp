#include "identify/command_line/solve_history.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "identify/command_line/condensed_at_values.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/text_table.h"
#include "vehicles/ride/stability.h"
#include "vehicles/simulation/multibody_system.h"

namespace fourpost {
namespace {

/// A history has a start: it can be drawn all the same.
void WarnOfGrowth(const Vehicle& vehicle, const CondensedModel& model, Diagnostics& findings) {
  const std::optional<Growth> growth = GrowthOf(vehicle, model);
  if (!growth) return;
  findings.Warning(vehicle.file, 0,
                   "the vehicle is unstable in its design pose: " + growth->Text() +
                       ", whatever the posts do; see `fourpost check`");
}

/// Tells how far a run is, and when another one, at half the step, begins.
class HistoryProgress {
 public:
  explicit HistoryProgress(const Drive& drive) : drive_(drive) {}

  /// Whether to go on.
  bool At(double t) {
    if (t < last_) {
      ++run_;
      began_s_ = line_.seconds();
    }
    last_ = t;
    const double start = drive_.start_s - drive_.lead_s;
    const double seconds = line_.seconds() - began_s_;
    line_.Show("simulate: " + Rounded(std::max(0.0, t), 3) + " of " + Rounded(drive_.end_s, 3) + " s" +
               TimeLeft((t - start) / (drive_.end_s - start), seconds) + Rate(t - start, seconds, "simulated s") +
               (run_ == 1 ? "" : "; step halved " + std::to_string(run_ - 1) + " times"));
    return !Interrupted();
  }

 private:
  const Drive& drive_;
  ProgressLine line_;
  double last_ = -HUGE_VAL;
  int run_ = 1;
  double began_s_ = 0;
};

/// Takes the extensions, the last readings, away.
Eigen::MatrixXd TakeExtensions(Eigen::Index sensors, TimeHistory& history) {
  Eigen::MatrixXd extensions = history.readings.rightCols(history.readings.cols() - sensors);
  history.readings.conservativeResize(Eigen::NoChange, sensors);
  return extensions;
}

}  // namespace

SolvedHistory SolveHistory(const SimulateCommand& command, const Vehicle& vehicle, const Drive& drive,
                           Diagnostics& findings) {
  Vehicle probed = vehicle;
  for (Sensor& sensor : ExtensionSensors(vehicle, RubbingDampers(vehicle))) probed.sensors.push_back(std::move(sensor));
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedModel model = CondensedAtValues(probed);
  WarnOfGrowth(vehicle, model, findings);
  const TimeGrid grid{drive.start_s, drive.end_s, command.rate_Hz, drive.lead_s};
  HistoryProgress progress(drive);
  const GoOn go_on = [&](double t) { return progress.At(t); };
  SolvedHistory solved;
  if (command.full) {
    Multibody multibody(probed);
    multibody.SetParameters(values, model.preloads);
    // Simbody weighs states by about 1 m, posts move by millimetres.
    MultibodySystem system(multibody, 1e-3 * command.error);
    solved.history = Simulate(system, drive.motion, grid, go_on);
    solved.interrupted = solved.history.size() < grid.lead_count() + grid.count();
  } else {
    CondensedHistory answer =
        SimulateCondensed(model, RigViewOf(probed), drive.motion, grid, {.error = command.error}, go_on);
    solved = {.history = std::move(answer.history), .step_s = answer.step_s, .interrupted = answer.ended};
    if (std::isfinite(answer.change)) solved.change = answer.change;
  }
  const Eigen::MatrixXd extensions = TakeExtensions(static_cast<Eigen::Index>(vehicle.sensors.size()), solved.history);
  if (!solved.interrupted) solved.locked = FindLockedFriction(vehicle, extensions, command.rate_Hz);
  return solved;
}

}  // namespace fourpost
