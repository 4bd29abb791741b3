#include "vehicles/response/harmonic_balance.h"

#include "analysis/text/count_check.h"
#include "analysis/text/option_check.h"
#include "vehicles/response/contact_cycle.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {

void HarmonicBalanceOptions::Validate() const {
  RequireOption(error > 0, "error", error, "positive");
  RequireOption(most_harmonics >= 9, "most_harmonics", most_harmonics, "at least 9");
  RequireOption(tolerance > 0, "tolerance", tolerance, "positive");
  RequireOption(max_iterations >= 1, "max_iterations", max_iterations, "at least 1");
}

PeriodicResponse SolveHarmonicBalance(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                      const Excitation& excitation, const HarmonicBalanceOptions& options) {
  options.Validate();
  excitation.Validate(static_cast<std::size_t>(model.post_stiffness.cols()));
  RequireCount("SolveHarmonicBalance", "sensors of the model", static_cast<std::size_t>(model.on_position.rows()),
               sensors.size());
  ContactCycle cycle(model, excitation.shape, options);
  ResponseRecorder recorder(sensors, excitation);
  PeriodicResponse out;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    options.deadline.Check();
    if (!cycle.Solve(excitation.frequency_Hz[i], excitation.amplitude_m[i]))
      out.unconverged_Hz.push_back(excitation.frequency_Hz[i]);
    recorder.Record(i, cycle.cycle().Sensors());
  }
  out.response = recorder.Take();
  return out;
}

}  // namespace fourpost
