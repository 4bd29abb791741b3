#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "analysis/frequency_response.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance_options.h"

namespace fourpost {

/// Where a vehicle set in motion from rest ends in another motion than the periodic one that was found.
struct OtherMotion {
  double frequency_Hz = 0;
  /// The channel that differs most, and by which share of itself.
  std::string channel;
  double difference = 0;
};

/// At which frequencies a vehicle may have several periodic motions, some of them unstable: at all with a knee or a
/// stop, else where a tyre that may lift off leaves its platform, or comes so near to it that less than a quarter of
/// its static load is left.
std::vector<bool> MayHaveSeveralMotions(const CondensedModel& model, const Excitation& excitation,
                                        const HarmonicBalanceOptions& options = {});

/// Balances do not tell whether the motion they find is stable. Runs the condensed vehicle from rest at each frequency
/// for which `looked_at` holds, and compares first harmonics with `found`, of the linearised balance: those that differ
/// by more than 5 % are told. Near a node, below 3 % of a channel's largest, differences count as a share of these 3 %;
/// channels that are silent, below 1 % of the loudest of their unit, are left out.
/// Frequencies without a finite value, and those at which the run fails, are left out. `progress` hears how many
/// frequencies are done, and may throw to end the work.
std::vector<OtherMotion> OtherMotionsFromRest(const CondensedModel& model, const Vehicle& vehicle,
                                              const Excitation& excitation, const std::vector<bool>& looked_at,
                                              const FrequencyResponse& found,
                                              const std::function<void(std::size_t done)>& progress = {});

}  // namespace fourpost
