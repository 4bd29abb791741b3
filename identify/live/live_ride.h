#pragma once

#include <span>

#include "vehicles/condensed/reduced_vehicle.h"
#include "vehicles/ride_metrics/ride_instruments.h"
#include "vehicles/ride_metrics/road_ride.h"

namespace fourpost {

/// The ride of a reduced vehicle whose parameters follow a hand, as `fourpost ride` finds it.
class LiveRide {
 public:
  /// `data`: of the instruments' vehicle; throws std::invalid_argument where it lacks what they name.
  LiveRide(ReducedData data, RideInstruments instruments);

  const RideInstruments& instruments() const { return instruments_; }

  /// At these values, SI, one per parameter. Throws as RideOnRoad(), and std::runtime_error for a vehicle that is
  /// unstable there.
  RoadRide Over(std::span<const double> values, const RoadRequest& request) const;

 private:
  ReducedVehicle vehicle_;
  RideInstruments instruments_;
};

}  // namespace fourpost
