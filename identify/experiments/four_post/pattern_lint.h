#pragma once

#include "analysis/text/found.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// At low frequencies, where a car follows its posts whatever its parameters are, its accelerations and forces look
/// like another motion (an error, for that is certain), or like none that these posts can make. Nothing where they are
/// as stated, and where that is unknown: no frequency is low enough. `run`: over all its frequencies.
Found PatternDoubt(const Vehicle& vehicle, const CondensedModel& model, const MeasuredRun& run);

}  // namespace fourpost
