#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "identify/audit/audit.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/study_file/channel_warnings.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// "14.0 kg (standard deviation 0.2 kg)": to the digits that the standard deviation supports.
std::string MassText(double kg, double sd);

/// Load cells that feel wheelpans the vehicle does not have, or the other way round, each kind as one warning.
/// `modelled` as ModelledResponses of the runs. The model, at the values of the file, says where to look; `audit`,
/// which is asked then and takes no mass nor rate from the file, says how much, and whether, where redundancy shows it.
void LintWheelpans(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                   const std::vector<FrequencyResponse>& modelled, const std::function<Audit()>& audit,
                   ChannelWarnings& warnings);

}  // namespace fourpost
