#pragma once

#include <fourpost/response.h>

#include "vehicles/engine/steady_response.h"
#include "vehicles/response/excitation.h"

namespace fourpost::api {

/// Throws FaultyInput.
Excitation ExcitationOf(const fourpost::Vehicle& vehicle, const SteppedSine& sine);

Response ResponseOf(const FrequencyResponse& found, fourpost::Engine engine);
Response ResponseOf(const SteadyResponse& answer);

}  // namespace fourpost::api
