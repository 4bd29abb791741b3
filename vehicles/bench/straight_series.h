#pragma once

#include <cstddef>
#include <vector>

#include "vehicles/bench/rate_piece.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// A linear spring k in series with a piecewise linear dashpot, integrated exactly. On a piece the dashpot has force f
/// = f_0 + c u, and with f' = k (v - u)
///   f' = -k/c (f - f_0) + k v(t),
/// whose solution for a parabolic rate v is an exponential plus a cubic. Where the force reaches the end of a piece,
/// the next one continues from that instant.
class StraightSeries {
 public:
  /// Whether the damper is of this kind: without friction, of strictly increasing force.
  static bool Holds(const SeriesDamper& damper);

  /// The spring starts unloaded. Pieces of motion last `usual_s` [s]; others take longer to compute. Needs Holds().
  StraightSeries(const SeriesDamper& damper, double usual_s);

  void Advance(const RatePiece& motion);

  double Force() const { return force_; }

 private:
  /// Factors of f - f_0, rate, acceleration and jerk at the start of a time step.
  struct Weights {
    double start = 0;
    double rate = 0;
    double acceleration = 0;
    double jerk = 0;
  };
  /// Piece of the dashpot between two forces.
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
  /// Time at which the force first reaches an end of its piece; the duration if it does not. `end`: the force then.
  double TimeWithin(const RatePiece& motion, double end) const;

  double stiffness_;
  double usual_s_;
  std::vector<Piece> pieces_;
  std::size_t piece_ = 0;
  double force_ = 0;
};

}  // namespace fourpost
