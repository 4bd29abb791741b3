#include "vehicles/bench/series_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vehicles/bench/implicit_series.h"
#include "vehicles/bench/rate_piece.h"
#include "vehicles/bench/straight_series.h"

namespace fourpost {
namespace {

/// From a sample on.
RatePiece PieceFrom(const BenchMotion& motion, std::size_t sample) {
  const std::size_t k = sample * motion.steps;
  const double duration = motion.step_s * static_cast<double>(motion.steps);
  const double acceleration = motion.acceleration[k];
  return {duration, motion.rate[k], acceleration, (motion.acceleration[k + motion.steps] - acceleration) / duration};
}

template <typename Stepper>
std::vector<double> Forces(Stepper stepper, const BenchMotion& motion) {
  std::vector<double> forces(motion.samples());
  for (std::size_t sample = 0; sample + 1 < forces.size(); ++sample) {
    stepper.Advance(PieceFrom(motion, sample));
    forces[sample + 1] = stepper.Force();
  }
  return forces;
}

/// More than the rms of the force that can come about: what the dashpot would have alone, and the spring alone.
double LikelyForce(const SeriesDamper& damper, const BenchMotion& motion) {
  double of_dashpot = 0;
  double of_spring = 0;
  for (std::size_t k = 0; k < motion.extension.size(); k += motion.steps) {
    of_dashpot += std::pow(damper.dashpot.Force(motion.rate[k]), 2);
    of_spring += std::pow(damper.spring.Force(motion.extension[k] - motion.extension[0]), 2);
  }
  return std::sqrt(std::min(of_dashpot, of_spring) / static_cast<double>(motion.samples()));
}

}  // namespace

std::vector<double> SeriesForces(const SeriesDamper& damper, const BenchMotion& motion, double tolerance) {
  // A damper at rest has no force to compare with.
  constexpr double kLeast_N = 1e-9;
  if (StraightSeries::Holds(damper))
    return Forces(StraightSeries(damper, motion.step_s * static_cast<double>(motion.steps)), motion);
  return Forces(ImplicitSeries(damper, std::max(kLeast_N, tolerance * LikelyForce(damper, motion))), motion);
}

}  // namespace fourpost
