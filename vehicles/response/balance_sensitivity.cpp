#include "vehicles/response/balance_sensitivity.h"

#include <algorithm>
#include <optional>

#include "vehicles/condensed/model_change.h"
#include "vehicles/response/balance_change.h"
#include "vehicles/response/contact_cycle.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {

ResponseSensitivity SolveBalanceSensitivity(const CondensedVehicle& vehicle, std::span<const double> values,
                                            const std::vector<std::size_t>& parameters, const Excitation& excitation,
                                            const HarmonicBalanceOptions& options) {
  const ModelChanges model_changes(vehicle, values);
  std::vector<ModelChange> changes;
  for (const std::size_t parameter : parameters) changes.push_back(model_changes.By(parameter));
  return SolveBalanceSensitivity(vehicle, model_changes.model(), changes, excitation, options);
}

ResponseSensitivity SolveBalanceSensitivity(const CondensedVehicle& vehicle, const CondensedModel& model,
                                            const std::vector<ModelChange>& changes, const Excitation& excitation,
                                            const HarmonicBalanceOptions& options) {
  options.Validate();
  excitation.Validate(vehicle.vehicle().posts.size());
  ContactCycle cycle(model, excitation.shape, options);
  // A balance of few harmonics is content with any error; its derivatives are not.
  const double error = std::min(options.error, HarmonicBalanceOptions{}.error);
  // One for either of its cycles.
  std::optional<BalanceChange> held;
  std::optional<BalanceChange> lifting;
  ResponseRecorder recorder(vehicle.vehicle().sensors, excitation);
  std::vector<ResponseRecorder> by_change(changes.size(), recorder);
  ResponseSensitivity out;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    if (!cycle.Solve(excitation.frequency_Hz[i], excitation.amplitude_m[i]))
      out.periodic.unconverged_Hz.push_back(excitation.frequency_Hz[i]);
    const SensorHarmonics sensors = cycle.cycle().Sensors();
    recorder.Record(i, sensors);
    std::optional<BalanceChange>& change = cycle.lifts() ? lifting : held;
    if (!change) change.emplace(cycle.cycle(), model, excitation.shape, changes, error);
    change->Find(excitation.amplitude_m[i]);
    for (std::size_t p = 0; p < changes.size(); ++p) by_change[p].RecordChange(i, sensors, change->Sensors(p));
  }
  out.periodic.response = recorder.Take();
  for (ResponseRecorder& one : by_change) out.by_change.push_back(one.Take());
  return out;
}

}  // namespace fourpost
