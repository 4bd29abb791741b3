#pragma once

#include "vehicles/bench/rate_piece.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// A series damper in time, of any dashpot in line with any increasing spring: y' = v(t) - u, dashpot(u) = spring(y).
/// Friction makes that stiff: the ratio of both slopes, the inverse of the time in which u follows v, changes by 1e4
/// and more between sticking and sliding. So the steps are those of the singly diagonally implicit Runge-Kutta method
/// of order 4 in five stages that is L-stable (Hairer and Wanner, Solving Ordinary Differential Equations II, table
/// 6.5), which damps whatever a step is too long for, and their length follows the error that its embedded formula of
/// order 3 estimates. The rate u of the dashpot is the unknown of each stage: no law is inverted, and what is solved
/// increases strictly.
class ImplicitSeries {
 public:
  /// The spring at rest. `tolerance_N`: of the force, in each step. The damper must outlive this.
  ImplicitSeries(const SeriesDamper& damper, double tolerance_N) : damper_(damper), tolerance_N_(tolerance_N) {}

  void Advance(const RatePiece& motion);

  /// NaN where a law has no answer.
  double Force() const { return damper_.spring.Force(extension_); }

 private:
  struct Trial {
    double extension = 0;
    double speed = 0;
    /// Of the force, estimated [N].
    double error = 0;
  };
  Trial Try(const RatePiece& motion, double start, double step) const;
  double Speed(double start, double share, double likely) const;

  const SeriesDamper& damper_;
  double tolerance_N_;
  /// Of the spring [m], of the dashpot [m/s].
  double extension_ = 0;
  double speed_ = 0;
  /// What the next step tries, as a share of a piece of motion.
  double share_ = 1;
};

}  // namespace fourpost
