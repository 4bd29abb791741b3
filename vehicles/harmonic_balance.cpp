#include "vehicles/harmonic_balance.h"

#include <stdexcept>
#include <string>

#include "vehicles/linearised_cycle.h"
#include "vehicles/response_recorder.h"

namespace fourpost {
namespace {

void Require(bool holds, const std::string& text) {
  if (!holds) throw std::invalid_argument("HarmonicBalanceOptions: " + text);
}

}  // namespace

void HarmonicBalanceOptions::Validate() const {
  Require(harmonics >= 2, "harmonics = " + std::to_string(harmonics) + " must be at least 2");
  Require(samples > 2 * harmonics, "samples = " + std::to_string(samples) + " must exceed twice the harmonics");
  Require(tolerance > 0, "tolerance = " + std::to_string(tolerance) + " must be positive");
  Require(max_iterations >= 1, "max_iterations = " + std::to_string(max_iterations) + " must be at least 1");
}

PeriodicResponse SolveHarmonicBalance(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                      const Excitation& excitation, const HarmonicBalanceOptions& options) {
  options.Validate();
  LinearisedCycle cycle(model, excitation.shape, options);
  ResponseRecorder recorder(sensors, excitation);
  PeriodicResponse out;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    if (!cycle.Solve(excitation.frequency_Hz[i], excitation.amplitude_m[i]))
      out.unconverged_Hz.push_back(excitation.frequency_Hz[i]);
    recorder.Record(i, cycle.Sensors());
  }
  out.response = recorder.Take();
  return out;
}

}  // namespace fourpost
