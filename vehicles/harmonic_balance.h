#pragma once

#include <vector>

#include "analysis/frequency_response.h"
#include "vehicles/condensed_model.h"
#include "vehicles/excitation.h"
#include "vehicles/vehicle.h"

namespace fourpost {

struct HarmonicBalanceOptions {
  /// Harmonics kept. Truncating a bilinear dashpot after 9 leaves about 2e-4 of the response.
  int harmonics = 9;
  /// Samples per cycle at which the dashpots are evaluated; aliasing of |v| falls with its square.
  int samples = 64;
  /// Largest change of any harmonic of any dashpot's velocity in the last iteration, relative to the largest of them.
  double tolerance = 1e-5;
  /// The iteration contracts at least by (rebound - compression)/(rebound + compression).
  int max_iterations = 200;

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
/// Each dashpot is split into its mean rate, solved exactly with the linear vehicle at each harmonic, and a remainder
/// that only depends on its own velocity. The remainders are iterated: time signal of the velocities -> remainders ->
/// harmonics -> velocities. Only the dashpots' velocities are unknown; the vehicle enters by its mobility at them.
/// `sensors` are those of the vehicle that `model` was condensed from.
/// Throws std::invalid_argument for options, an excitation or sensors that do not fit.
PeriodicResponse SolveHarmonicBalance(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                      const Excitation& excitation, const HarmonicBalanceOptions& options = {});

}  // namespace fourpost
