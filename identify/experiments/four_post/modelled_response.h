#pragma once

#include <vector>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/fit_balance.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/experiments/four_post/response_bands.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost {

/// What the model answers to an excitation: by harmonic balance, with hysteresis by Fourier coefficients of the
/// reduced model integrated in time until its motion repeats (thesis 4.2.3), to a thousandth. `integrates`: whether
/// motions that no balance finds, of wheels that lift, are found so as well.
PeriodicResponse ModelledResponse(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                  const Excitation& excitation, const Deadline& deadline = {}, bool integrates = true);

/// What the model answers to the excitation of each run, see ModelledResponse: one channel per sensor, NaN at
/// frequencies where no periodic response was found.
std::vector<FrequencyResponse> ModelledResponses(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                                 const std::vector<MeasuredRun>& runs);

/// Measurement and model side by side as comma-separated text: one row per recording, channel and frequency, gains and
/// phases relative to the reference post as in the recordings, mean offsets in the channel's unit. `in_band` is 1 where
/// IsInBand(), but for recordings that are kept for validation. Standard deviations of the repeats are empty where
/// there were none. `start`: what the vehicle answers as its file has it; none of it when empty. `bands`: one per run,
/// half widths of 95 %; no columns of them when empty.
std::string ResponseCsv(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                        double lower_Hz, double upper_Hz, const std::vector<FrequencyResponse>& start = {},
                        const std::vector<ResponseBands>& bands = {});

}  // namespace fourpost
