#pragma once

#include <vector>

#include "analysis/frequency_response.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance_options.h"

namespace fourpost {

struct PeriodicResponse {
  FrequencyResponse response;
  /// Frequencies at which the iteration did not converge; their values are the last iterate.
  std::vector<double> unconverged_Hz;
};

/// Steady response of a condensed vehicle to a stepped sine, by harmonic balance with alternating frequency/time.
///
/// Each element that is not linear, a dashpot, a knee, a stop, a tyre that lifts off, is split into a linear share,
/// solved exactly with the vehicle at each harmonic, and a remainder that only depends on its own extension and rate
/// (Port). The remainders are iterated: time signals of extension and rate -> remainders -> harmonics -> extensions.
/// Only the elements' extensions are unknown; the vehicle enters by its receptance at them. Harmonics are added until
/// the error is met. Frequencies are taken in the order given: where several motions are possible, as behind a stop,
/// each takes after the one before, so that a rising and a falling sweep may differ, as they do on a rig.
/// `sensors` are those of the vehicle that `model` was condensed from.
/// Throws std::invalid_argument for options, an excitation or sensors that do not fit.
PeriodicResponse SolveHarmonicBalance(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                      const Excitation& excitation, const HarmonicBalanceOptions& options = {});

}  // namespace fourpost
