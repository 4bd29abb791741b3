#pragma once

#include "identify/experiments/recorded_motion.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// How posts and vehicle move, for a picture: by the reduced model at the vehicle's values, to a hundredth; `when`: of
/// which the rate is not looked at. 60 frames a second, fewer where there would be more than 60000 numbers. Throws as
/// SimulateCondensed() does.
HistoryMotion SimulatedMotion(const Vehicle& vehicle, const PostMotion& posts, TimeGrid when);

}  // namespace fourpost
