#pragma once

#include "vehicles/condensed/reduced_fields.h"
#include "vehicles/ride_metrics/ride_instruments.h"

namespace fourpost {

// What a ride needs besides the reduced vehicle, see reduced_fields.h: of the vehicle the elements by which its numbers
// are named.

void EachField(MaybeConst<Tyre> auto& tyre, auto&& field) {
  field("name", tyre.name);
  field("lifts_off", tyre.lifts_off);
  field("law", tyre.law);
}

void EachField(MaybeConst<Damper> auto& damper, auto&& field) {
  field("name", damper.name);
  field("law", damper.law);
  field("hydraulic", damper.hydraulic);
}

void EachField(MaybeConst<Spring> auto& spring, auto&& field) {
  field("name", spring.name);
  field("law", spring.law);
}

void EachField(MaybeConst<RoadTracks::Place> auto& place, auto&& field) {
  field("side", place.side);
  field("behind", place.behind);
}

void EachField(MaybeConst<RoadTracks> auto& tracks, auto&& field) {
  field("posts", tracks.posts);
  field("distance", tracks.distance);
}

void EachField(MaybeConst<RideInstruments::Felt> auto& felt, auto&& field) {
  // As Weighting.
  static constexpr std::array<const char*, kWeightings.size()> kNames = {"Wk", "Wd", "We", "Wf", "Wb"};
  field("name", felt.name);
  field("sensor", felt.sensor);
  field.Choice("weighting", felt.weighting, kNames);
}

void EachField(MaybeConst<RideInstruments::Stop> auto& stop, auto&& field) {
  field("spring", stop.spring);
  field("sensor", stop.sensor);
}

void EachField(MaybeConst<RideInstruments::Chassis> auto& chassis, auto&& field) {
  field("centre", chassis.centre);
  field("ahead", chassis.ahead);
  field("left", chassis.left);
}

void EachField(MaybeConst<RideInstruments::Axle> auto& axle, auto&& field) {
  field("name", axle.name);
  field("tyres", axle.tyres);
  field("posts", axle.posts);
  field("height", axle.height);
}

void EachField(MaybeConst<RideInstruments> auto& instruments, auto&& field) {
  field("file_sensors", instruments.file_sensors);
  field("tracks", instruments.tracks);
  field("tyres", instruments.vehicle.tyres);
  field("dampers", instruments.vehicle.dampers);
  field("springs", instruments.vehicle.springs);
  field("points", instruments.points);
  field("loads", instruments.loads);
  field("extensions", instruments.dampers);
  field("stops", instruments.stops);
  field("chassis", instruments.chassis);
  field("axles", instruments.axles);
}

}  // namespace fourpost
