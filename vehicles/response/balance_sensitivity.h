#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/harmonic_balance_options.h"

namespace fourpost {

struct ResponseSensitivity {
  PeriodicResponse periodic;
  /// Derivatives of the response per SI unit of each parameter asked for: channels' response, mean and second_harmonic.
  /// The latter, an amplitude, has no derivative where it is zero, and gives zero there.
  std::vector<FrequencyResponse> by_parameter;
};

/// The response of SolveHarmonicBalance and its derivatives by parameters, both together for less than four times the
/// cost of the response alone with two dampers and a dozen parameters: the balance is differentiated, see
/// BalanceChange. By the default error they are within some 3e-3 of each channel's largest, means within 1e-2, second
/// harmonics within some 3e-2, and by less of it in proportion. At a kink of a law, as where a motion begins to touch a
/// stop, they are of one side. Friction, with more harmonics than are solved for here, leaves a tenth. Where the
/// balance did not converge they are those of its last iterate. `values`: SI, in the order of Vehicle::parameters;
/// `parameters`: indices of those to differentiate by. Throws as SolveHarmonicBalance and ModelChanges.
ResponseSensitivity SolveBalanceSensitivity(const CondensedVehicle& vehicle, std::span<const double> values,
                                            const std::vector<std::size_t>& parameters, const Excitation& excitation,
                                            const HarmonicBalanceOptions& options = {});

}  // namespace fourpost
