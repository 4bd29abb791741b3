#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/model_change.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/harmonic_balance_options.h"

namespace fourpost {

struct ResponseSensitivity {
  PeriodicResponse periodic;
  /// Derivatives of the response per SI unit of each requested parameter, or by each change of the model: channels'
  /// response, mean and second_harmonic. The latter is an amplitude; where it is zero it has no derivative, and zero is
  /// returned.
  std::vector<FrequencyResponse> by_change;
};

/// The response of SolveHarmonicBalance and its derivatives by parameters. Both together cost less than four times the
/// response alone with two dampers and a dozen parameters, because the harmonic balance itself is differentiated, see
/// BalanceChange. At the default error they are within some 3e-3 of each channel's largest, means within 1e-2, second
/// harmonics within some 3e-2; a smaller error reduces these in proportion. At a kink of a law, as where a motion
/// begins to touch a stop, they are one-sided. Friction, with more harmonics than are solved for here, leaves a tenth.
/// Where the harmonic balance did not converge they are those of its last iterate. `values`: SI, in the order of
/// Vehicle::parameters; `parameters`: indices of those to differentiate by. Throws as SolveHarmonicBalance and
/// ModelChanges.
ResponseSensitivity SolveBalanceSensitivity(const CondensedVehicle& vehicle, std::span<const double> values,
                                            const std::vector<std::size_t>& parameters, const Excitation& excitation,
                                            const HarmonicBalanceOptions& options = {});

/// By any changes of a vehicle's model, as to other vehicles: to first order in all that is different.
ResponseSensitivity SolveBalanceSensitivity(const CondensedVehicle& vehicle, const CondensedModel& model,
                                            const std::vector<ModelChange>& changes, const Excitation& excitation,
                                            const HarmonicBalanceOptions& options = {});

}  // namespace fourpost
