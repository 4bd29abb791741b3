#pragma once

#include <vector>

#include "analysis/signals/frequency_response.h"
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

/// Steady response of a reduced vehicle to a stepped sine, by harmonic balance with alternating frequency/time.
///
/// Each nonlinear element (dashpot, knee, stop, tyre that lifts off) is split into a linear part, solved exactly with
/// the vehicle at each harmonic, and a nonlinear part that depends only on its own extension and rate (Port). The
/// nonlinear parts are iterated: time signals of extension and rate -> forces -> harmonics -> extensions. Only the
/// elements' extensions are unknown; the vehicle enters by its receptance at them. Harmonics are added until the error
/// is met. Frequencies are solved in the given order. If several motions are possible, as behind a stop, each frequency
/// follows the one before, so that a rising and a falling sweep may differ, as on a rig. `sensors` are those of the
/// vehicle of `model`. Throws std::invalid_argument for options, an excitation or sensors that do not fit.
PeriodicResponse SolveHarmonicBalance(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                      const Excitation& excitation, const HarmonicBalanceOptions& options = {});

}  // namespace fourpost
