#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// One warning for all channels of stepped sines that are off by more than four times what noise and the stated model
/// error explain, as a root mean square over the band. `in_band`: the runs there; `model`: of the fitted vehicle;
/// `is_cleared`: whether the audit of the rig clears these channels, so that it is the model. Asked once, if at all.
void LintChannels(const FourPostPlan& plan, const std::vector<MeasuredRun>& in_band, const Vehicle& vehicle,
                  const CondensedModel& model,
                  const std::function<bool(const std::vector<std::string>& channels)>& is_cleared,
                  Diagnostics& diagnostics);

}  // namespace fourpost
