#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance_options.h"

namespace fourpost {

/// A frequency at which a vehicle, started from rest, reaches another motion than the periodic one that was found.
struct OtherMotion {
  double frequency_Hz = 0;
  /// The channel that differs most, and its relative difference.
  std::string channel;
  double difference = 0;
};

/// Frequencies at which a vehicle may have several periodic motions, some of them unstable: all of them with a knee or
/// a stop, otherwise those at which a tyre that may lift off leaves its platform, or keeps less than a quarter of its
/// static load.
std::vector<bool> MayHaveSeveralMotions(const CondensedModel& model, const Excitation& excitation,
                                        const HarmonicBalanceOptions& options = {});

/// Harmonic balance does not show whether its motion is stable. This integrates the reduced vehicle from rest at each
/// frequency for which `looked_at` holds, and compares first harmonics with `found`, of the linearised harmonic
/// balance; differences of more than 5 % are reported. Near a node, below 3 % of a channel's largest, differences are
/// relative to these 3 %; channels that are silent, below 1 % of the loudest of their unit, are left out. Frequencies
/// without a finite value, and those at which the integration fails, are left out. `progress` is called with the number
/// of frequencies done, and may throw to end the work.
std::vector<OtherMotion> OtherMotionsFromRest(const CondensedModel& model, const Vehicle& vehicle,
                                              const Excitation& excitation, const std::vector<bool>& looked_at,
                                              const FrequencyResponse& found,
                                              const std::function<void(std::size_t done)>& progress = {});

}  // namespace fourpost
