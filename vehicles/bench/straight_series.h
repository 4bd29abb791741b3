#pragma once

#include <cstddef>
#include <vector>

#include "vehicles/bench/rate_piece.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// A linear spring k in line with a dashpot of straight pieces, in time and exactly. On a piece the dashpot has
/// force f = f_0 + c u, and with f' = k (v - u)
///   f' = -k/c (f - f_0) + k v(t),
/// whose solution for a rate v that goes as a parabola is an exponential and a cubic. Where the force comes to the end
/// of a piece, the next one goes on from that instant.
class StraightSeries {
 public:
  /// Whether a damper is of that kind: without friction, of strictly increasing force.
  static bool Holds(const SeriesDamper& damper);

  /// The spring at rest; pieces of motion last `usual_s` [s], others take longer to compute. Needs Holds().
  StraightSeries(const SeriesDamper& damper, double usual_s);

  void Advance(const RatePiece& motion);

  double Force() const { return force_; }

 private:
  /// What a time makes of f - f_0 at its start, and of rate, acceleration and jerk.
  struct Weights {
    double start = 0;
    double rate = 0;
    double acceleration = 0;
    double jerk = 0;
  };
  /// Of the dashpot, between two forces.
  struct Piece {
    double lower = 0;
    double upper = 0;
    /// f_0 and c.
    double offset = 0;
    double slope = 0;
    Weights usual;
  };
  Weights WeightsOf(const Piece& piece, double t) const;
  double ForceAt(const RatePiece& motion, double t) const;
  /// f'.
  double Trend(const Piece& piece, double force, double rate) const;
  void EnterPieceOf(const RatePiece& motion);
  /// Time at which the force first comes to an end of its piece; the duration where it does not. `end`: the force then.
  double TimeWithin(const RatePiece& motion, double end) const;

  double stiffness_;
  double usual_s_;
  std::vector<Piece> pieces_;
  std::size_t piece_ = 0;
  double force_ = 0;
};

}  // namespace fourpost
