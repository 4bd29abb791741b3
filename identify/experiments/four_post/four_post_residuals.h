#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/experiments/known_answers.h"
#include "identify/residuals/residual_block.h"
#include "identify/study_file/calibration.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {

/// How far the vehicle is from stepped-sine responses:
/// - per channel, recording and frequency the difference of the complex responses, resolved along and across the
///   measured phasor: to first order the error of gain and of phase, but without a jump at 180 degrees and finite where
///   a gain passes through zero. Each is divided by the root of the measured variance plus the squares of the model
///   error and of its floor;
/// - mean strut offsets over the root of their variance plus the square of the model error of means: they alone
///   distinguish bump from rebound.
/// `runs` hold only the frequencies to fit. `integrates`: see ModelledResponse(). `answers`: of the same vehicle, at
/// one set of values; null: nothing is remembered.
ResidualBlock FourPostResiduals(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredRun> runs,
                                const ModelError& model_error, const std::vector<Calibration>& calibrations = {},
                                bool integrates = true, std::shared_ptr<KnownAnswers> answers = nullptr);

/// Sum of the squares of both residuals of the response of a run's channel at its frequency `i`; NaN where the model
/// has no answer.
double SquaredDeviation(const MeasuredRun& run, const MeasuredChannel& channel, const FrequencyResponse& modelled,
                        const ModelError& model_error, std::size_t i);

/// Root mean square of those residuals for each channel of a run: how many times what noise and model error explain.
/// `modelled`: the answer at the run's frequencies, one channel per sensor of the vehicle. Frequencies at which it has
/// none are left out; NaN where that is all of them.
std::vector<double> ResponseDeviations(const MeasuredRun& run, const FrequencyResponse& modelled,
                                       const ModelError& model_error);

}  // namespace fourpost
