#pragma once

#include <cstdint>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/posts/road_tracks.h"

namespace fourpost {

/// A random road under a vehicle at constant speed. Each track has the spectral density RoadDensity() within the
/// band of frequencies that the posts follow, left and right track the coherence TrackCoherence(); the vehicle enters
/// from and leaves to a level road within a second.
struct RandomRoad {
  double roughness_m3 = 0;
  /// m/s.
  double speed = 0;
  double lower_Hz = 0.5;
  double upper_Hz = 30;
  double duration_s = 0;
  std::uint64_t seed = 0;

  /// Motion of the vehicle's posts from t = 0, when the foremost meets the road. Each follows the track of its side,
  /// delayed by its distance from the foremost post over speed, see RoadTracks. Throws
  /// std::invalid_argument naming the field that is out of bounds.
  PostMotion MotionOf(const Vehicle& vehicle) const;
};

}  // namespace fourpost
