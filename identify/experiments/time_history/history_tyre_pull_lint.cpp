#include "identify/experiments/time_history/history_tyre_pull_lint.h"

#include "identify/experiments/time_history/history_simulation.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/tyre_pull.h"

namespace fourpost {

void LintTyrePulls(const Vehicle& vehicle, std::span<const double> values,
                   const std::vector<MeasuredHistory>& histories, const std::vector<double>& steps_s,
                   Diagnostics& diagnostics) {
  Vehicle probed = vehicle;
  probed.sensors = ForceSensors(vehicle, LinearTyres(vehicle));
  if (probed.sensors.empty() || histories.empty()) return;
  const CondensedVehicle condensed(probed);
  const CondensedVehicle own(vehicle);
  for (std::size_t h = 0; h < histories.size(); ++h) {
    const std::vector<double> at = histories[h].setting.At({values.begin(), values.end()});
    const CondensedModel model = condensed.At(at);
    const HistorySimulation simulation(histories[h], steps_s[h]);
    const Eigen::MatrixXd forces = simulation.Readings(model, simulation.StateOf(own.At(at)));
    WarnOfPulls(vehicle, FindTyrePulls(vehicle, model.preloads.tyre, forces), "samples", "'" + histories[h].name + "'",
                diagnostics);
  }
}

}  // namespace fourpost
