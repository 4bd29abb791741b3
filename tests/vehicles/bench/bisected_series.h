#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vehicles/bench/bench_motion.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// What SeriesForces solves, in another way: `steps` equal steps a sample of the two-stage method of order 2 that is
/// L-stable (Alexander, SIAM J. Numer. Anal. 14 (1977) 1006), each stage by bisection, no slope of any law.
inline std::vector<double> BisectedForces(const SeriesDamper& damper, const BenchMotion& motion, int steps) {
  const double diagonal = 1 - std::sqrt(0.5);
  const double sample_s = motion.step_s * static_cast<double>(motion.steps);
  const double h = sample_s / steps;
  double y = 0;
  // u where dashpot(u) = spring(start - share u).
  const auto speed = [&](double start, double share) {
    constexpr double kClose = 1e-10;  // m/s
    auto [lower, upper] = std::minmax({0.0, start / share});
    double from = lower;
    double to = upper;
    while (to - from > kClose) {
      const double u = 0.5 * (from + to);
      if (u <= from || u >= to) break;
      (damper.dashpot.Force(u) > damper.spring.Force(start - share * u) ? to : from) = u;
    }
    return 0.5 * (from + to);
  };
  std::vector<double> forces = {damper.spring.Force(0)};
  for (std::size_t k = 0; k + motion.steps < motion.rate.size(); k += motion.steps) {
    const double jerk = (motion.acceleration[k + motion.steps] - motion.acceleration[k]) / sample_s;
    const auto rate = [&](double t) { return motion.rate[k] + motion.acceleration[k] * t + 0.5 * jerk * t * t; };
    for (int i = 0; i < steps; ++i) {
      const double inner = rate((i + diagonal) * h);
      const double start = y + diagonal * h * inner;
      const double slope = inner - speed(start, diagonal * h);
      const double last = y + h * (1 - diagonal) * slope + diagonal * h * rate((i + 1) * h);
      y = last - diagonal * h * speed(last, diagonal * h);
    }
    forces.push_back(damper.spring.Force(y));
  }
  return forces;
}

}  // namespace fourpost
