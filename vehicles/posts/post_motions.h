#pragma once

#include <cstddef>
#include <vector>

#include "analysis/signals/uniform_spline.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// All posts follow one signal, each by its share: a post pattern, see PostPattern. Those without a
/// share rest.
PostMotion FollowPattern(UniformSpline signal, std::vector<double> shape);

/// A signal that a post follows after a delay [s].
struct DelayedTrack {
  UniformSpline signal;
  double delay_s = 0;
};

/// Each post follows its own; actuators behind them theirs, or carry none.
PostMotion FollowTracks(std::vector<DelayedTrack> tracks);

/// Height farthest from rest of each post at start, start + step, ... up to end [m]; signed.
std::vector<double> FarthestHeights(const PostMotion& motion, std::size_t post_count, double start, double end,
                                    double step);

}  // namespace fourpost
