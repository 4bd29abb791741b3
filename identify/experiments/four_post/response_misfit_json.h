#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/four_post/response_misfit.h"

namespace fourpost {

/// "rms_dB", "rms_deg" and "nmse_percent"; what is not finite is null.
nlohmann::ordered_json ErrorsJson(const ChannelMisfit& misfit);

/// Of each channel its "name", ErrorsJson(), "vaf_percent" and, where they are known, "misfit" and "worst".
nlohmann::ordered_json ResponseMisfitsJson(const std::vector<ChannelMisfit>& misfits);

/// The same of each "recording" that was kept for validation.
nlohmann::ordered_json UnseenMisfitsJson(const std::vector<MeasuredRun>& unseen,
                                         const std::vector<FrequencyResponse>& predicted,
                                         const ModelError& model_error);

}  // namespace fourpost
