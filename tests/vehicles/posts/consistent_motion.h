#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Velocity and acceleration must be central differences of height and velocity: their largest departures over all
/// posts, relative to the largest of each.
struct Departure {
  double velocity = 0;
  double acceleration = 0;
};

inline Departure DepartureOf(const PostMotion& motion, std::size_t posts, double start, double end, double step) {
  constexpr double kShare = 1e-3;
  const double h = kShare * step;
  std::vector<PostState> before(posts);
  std::vector<PostState> now(posts);
  std::vector<PostState> after(posts);
  Departure departure;
  Departure largest;
  // Not at the samples themselves, where the acceleration of a spline has its kinks.
  for (double t = start + 0.37 * step; t < end; t += step) {
    motion(t - h, before);
    motion(t, now);
    motion(t + h, after);
    for (std::size_t p = 0; p < posts; ++p) {
      const double velocity = (after[p].height - before[p].height) / (2 * h);
      const double acceleration = (after[p].velocity - before[p].velocity) / (2 * h);
      departure.velocity = std::max(departure.velocity, std::abs(velocity - now[p].velocity));
      departure.acceleration = std::max(departure.acceleration, std::abs(acceleration - now[p].acceleration));
      largest.velocity = std::max(largest.velocity, std::abs(now[p].velocity));
      largest.acceleration = std::max(largest.acceleration, std::abs(now[p].acceleration));
    }
  }
  EXPECT_GT(largest.velocity, 0);
  EXPECT_GT(largest.acceleration, 0);
  return {departure.velocity / largest.velocity, departure.acceleration / largest.acceleration};
}

/// Rounding of a difference over a thousandth of a sample, and what its third derivative leaves.
inline void ExpectConsistent(const PostMotion& motion, std::size_t posts, double start, double end, double step) {
  const Departure departure = DepartureOf(motion, posts, start, end, step);
  EXPECT_LT(departure.velocity, 1e-6);
  EXPECT_LT(departure.acceleration, 1e-6);
}

}  // namespace fourpost
