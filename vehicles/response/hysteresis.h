#pragma once

#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// Whether the model has hysteresis: friction alone in series with a spring. It sticks and slides within a cycle with
/// nearly no rate of its own. Harmonic balance then converges at half of the frequencies only, with errors of up to 1
/// %; time integration is used instead.
bool HasHysteresis(const CondensedModel& model);

}  // namespace fourpost
