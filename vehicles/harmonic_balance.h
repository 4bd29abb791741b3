#pragma once

#include <vector>

#include "analysis/frequency_response.h"
#include "vehicles/condensed_model.h"
#include "vehicles/excitation.h"
#include "vehicles/vehicle.h"

namespace fourpost {

struct HarmonicBalanceOptions {
  /// Largest share of itself that the last doubling of harmonics and samples changed the first harmonic of any sensor
  /// by; of a sensor near a node, that share of 3 % of what it could read. What is left is some third to one and a half
  /// of it.
  double error = 2e-4;
  /// Gives up where the error needs more harmonics than these. Friction needs some that resolve
  /// its step.
  int most_harmonics = 257;
  /// Largest change of any harmonic of any port's rate in the last iteration, relative to the largest of them.
  double tolerance = 2e-5;
  /// At each number of harmonics.
  int max_iterations = 60;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

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
