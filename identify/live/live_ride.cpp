#include "identify/live/live_ride.h"

#include <stdexcept>
#include <utility>

#include "analysis/numerics/decompositions.h"
#include "vehicles/condensed/modes.h"

namespace fourpost {

LiveRide::LiveRide(ReducedData data, RideInstruments instruments)
    : vehicle_(std::move(data)), instruments_(std::move(instruments)) {}

RoadRide LiveRide::Over(std::span<const double> values, const RoadRequest& request) const {
  const CondensedModel model = vehicle_.At(values);
  if (EigenvaluesOf(StateMatrix(model)).real().maxCoeff() >= kSlowestMotion_per_s)
    throw std::runtime_error("the vehicle is unstable at these values");
  return RideOnRoad(instruments_, model, values, request);
}

}  // namespace fourpost
