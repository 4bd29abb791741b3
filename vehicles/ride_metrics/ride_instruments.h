#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/comfort/weighting.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/posts/road_tracks.h"

namespace fourpost {

/// A point whose acceleration is felt, in a direction.
struct RidePoint {
  std::string name;
  Point point;
  /// Unit vector in link axes.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  Weighting weighting = Weighting::kWk;
};

/// A vehicle with the sensors that its ride metrics need, and which of its sensors they are: indices in
/// vehicle.sensors. Any engine that reads sensors then gives ride metrics.
struct RideInstruments {
  /// The sensors of the file come first.
  Vehicle vehicle;
  std::size_t file_sensors = 0;
  /// Of its posts.
  RoadTracks tracks;

  /// An accelerometer.
  struct Felt {
    std::string name;
    std::size_t sensor = 0;
    Weighting weighting = Weighting::kWk;
  };
  std::vector<Felt> points;
  /// Load cells, one per tyre.
  std::vector<std::size_t> loads;
  /// Extensions of the dampers' lines, one per damper.
  std::vector<std::size_t> dampers;

  /// A bump or rebound stop and the extension of its line.
  struct Stop {
    /// Index in vehicle.springs.
    std::size_t spring = 0;
    std::size_t sensor = 0;
  };
  std::vector<Stop> stops;

  /// Heights of the chassis at its centre of mass and kLever_m ahead and to the left of it.
  struct Chassis {
    std::size_t centre = 0;
    std::size_t ahead = 0;
    std::size_t left = 0;
  };
  std::optional<Chassis> chassis;
  static constexpr double kLever_m = 1;

  struct Axle {
    std::string name;
    /// Indices in vehicle.tyres.
    std::vector<std::size_t> tyres;
    /// Indices in vehicle.posts of those under its tyres.
    std::vector<std::size_t> posts;
    /// Height of the chassis above the axle's middle; empty without a chassis.
    std::optional<std::size_t> height;
  };
  /// From front to rear.
  std::vector<Axle> axles;
};

/// Points are the vehicle's accelerometers on its chassis, then `more`; without any, the chassis's centre of mass.
/// Vertical directions are weighted by Wk, others by Wd. Throws FaultyInput if the loops cannot be assembled.
RideInstruments InstrumentRide(const Vehicle& vehicle, const std::vector<RidePoint>& more = {});

}  // namespace fourpost
