#include "identify/live/live_ride.h"

#include <stdexcept>
#include <utility>

#include "analysis/numerics/decompositions.h"
#include "vehicles/condensed/modes.h"

namespace fourpost {
namespace {

/// Whether every index of the instruments names something: a page may be damaged.
bool AreOf(const ReducedData& data, const RideInstruments& instruments) {
  const std::size_t tyres = instruments.vehicle.tyres.size();
  bool good = instruments.file_sensors <= data.sensors.size() && instruments.loads.size() == tyres &&
              instruments.dampers.size() == instruments.vehicle.dampers.size();
  const auto reads = [&](std::size_t sensor) { good = good && sensor < data.sensors.size(); };
  const auto below = [&](std::size_t index, std::size_t count) { good = good && index < count; };
  for (const RideInstruments::Felt& point : instruments.points) reads(point.sensor);
  for (const std::size_t sensor : instruments.loads) reads(sensor);
  for (const std::size_t sensor : instruments.dampers) reads(sensor);
  for (const RideInstruments::Stop& stop : instruments.stops) {
    reads(stop.sensor);
    below(stop.spring, instruments.vehicle.springs.size());
  }
  if (const auto& chassis = instruments.chassis)
    for (const std::size_t sensor : {chassis->centre, chassis->ahead, chassis->left}) reads(sensor);
  for (const RideInstruments::Axle& axle : instruments.axles) {
    for (const std::size_t tyre : axle.tyres) below(tyre, tyres);
    for (const std::size_t post : axle.posts) below(post, instruments.tracks.posts.size());
    if (axle.height) reads(*axle.height);
  }
  return good;
}

}  // namespace

LiveRide::LiveRide(ReducedData data, RideInstruments instruments)
    : vehicle_(std::move(data)), instruments_(std::move(instruments)) {
  if (!AreOf(vehicle_.data(), instruments_))
    throw std::invalid_argument("the ride's instruments are not those of the vehicle");
}

RoadRide LiveRide::Over(std::span<const double> values, const RoadRequest& request) const {
  const CondensedModel model = vehicle_.At(values);
  // Negated: NaN is no stable motion.
  if (!(EigenvaluesOf(StateMatrix(model)).real().maxCoeff() < kSlowestMotion_per_s))
    throw std::runtime_error("the vehicle is unstable at these values");
  return RideOnRoad(instruments_, model, values, request);
}

}  // namespace fourpost
