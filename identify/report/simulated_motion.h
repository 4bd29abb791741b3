#pragma once

#include "identify/experiments/recorded_motion.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// How posts and vehicle move, for a picture: by the reduced model at the vehicle's values, to a hundredth; `when`: of
/// which the rate is not looked at. 60 frames a second or more: three at least in a period of `upper_Hz`, the highest
/// frequency of the posts, and where that is 0, of the highest one that the motion holds. Ends early where there would
/// be more than 200000 numbers. Throws as SimulateCondensed() does.
HistoryMotion SimulatedMotion(const Vehicle& vehicle, const PostMotion& posts, TimeGrid when, double upper_Hz);

}  // namespace fourpost
