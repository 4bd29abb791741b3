#pragma once

#include "vehicles/bench/rate_piece.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// Time integration of any dashpot in series with any increasing spring: y' = v(t) - u, dashpot(u) = spring(y).
/// Friction makes this stiff: the ratio of both slopes, the inverse of the time in which u follows v, changes by 1e4
/// and more between sticking and sliding. The method is the L-stable singly diagonally implicit Runge-Kutta method of
/// order 4 in five stages (Hairer and Wanner, Solving Ordinary Differential Equations II, table 6.5). It damps all
/// motion too fast for a step; the embedded formula of order 3 estimates the error and sets the step. The rate u of the
/// dashpot is the unknown of each stage, so no law is inverted and the equation to solve increases strictly.
class ImplicitSeries {
 public:
  /// The spring starts unloaded. `tolerance_N`: force error per step. The damper must outlive this.
  ImplicitSeries(const SeriesDamper& damper, double tolerance_N) : damper_(damper), tolerance_N_(tolerance_N) {}

  void Advance(const RatePiece& motion);

  /// NaN if a law has no solution.
  double Force() const { return damper_.spring.Force(extension_); }

 private:
  struct Trial {
    double extension = 0;
    double speed = 0;
    /// Estimated error of the force [N].
    double error = 0;
  };
  Trial Try(const RatePiece& motion, double start, double step) const;
  double Speed(double start, double share, double likely) const;

  const SeriesDamper& damper_;
  double tolerance_N_;
  /// Extension of the spring [m], rate of the dashpot [m/s].
  double extension_ = 0;
  double speed_ = 0;
  /// Length that the next step tries, as a share of a piece of motion.
  double share_ = 1;
};

}  // namespace fourpost
