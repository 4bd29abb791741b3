#pragma once

#include <functional>
#include <span>
#include <vector>

namespace fourpost {

/// A post's platform, positive upward from rest.
struct PostState {
  double height = 0;        // m
  double velocity = 0;      // m/s
  double acceleration = 0;  // m/s^2
};

/// Motion of the post platforms at time t [s]; one entry per post, and behind these one per actuator, whose tension [N]
/// and rates stand in place of heights.
using PostMotion = std::function<void(double t, std::span<PostState> posts)>;

/// The posts at one time.
using Platforms = std::vector<PostState>;

}  // namespace fourpost
