#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fourpost {

/// Monotone curve y(x) through given points: piecewise cubic with continuous slope. Inner slopes are those of the
/// parabola through three neighbours, end slopes those of the chord, both reduced where the cubic would otherwise
/// overshoot (Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238, region of radius 3). Linear beyond the ends.
class MonotoneCurve {
 public:
  /// At least two points, all finite, x strictly increasing, y not falling; else throws std::invalid_argument with the
  /// given names of x and y. If y strictly increases over all points, so does the curve everywhere.
  MonotoneCurve(std::vector<double> x, std::vector<double> y, const std::string& x_name = "MonotoneCurve: x",
                const std::string& y_name = "MonotoneCurve: y");

  double Value(double x) const;
  double Slope(double x) const;
  /// From 0 to x.
  double Integral(double x) const;

  /// The x at which the curve reaches y; needs a strictly increasing curve.
  double Argument(double y) const;

  /// Over all x, exact.
  double LeastSlope() const;
  double GreatestSlope() const;

  /// Places of the points.
  const std::vector<double>& x() const { return x_; }

  bool operator==(const MonotoneCurve&) const = default;

 private:
  /// y = y0 + (slope + (quadratic + cubic e) e) e, e = x - x0. (x0, y0) is the end nearer to x = 0, where a force law
  /// needs full precision.
  struct Piece {
    double x0 = 0;
    double y0 = 0;
    double slope = 0;
    double quadratic = 0;
    double cubic = 0;

    bool operator==(const Piece&) const = default;
    double Rise(double e) const { return (slope + (quadratic + cubic * e) * e) * e; }
    double SlopeAt(double e) const { return slope + (2 * quadratic + 3 * cubic * e) * e; }
    /// From x = x0.
    double Area(double e) const { return (y0 + (slope / 2 + (quadratic / 3 + cubic / 4 * e) * e) * e) * e; }
  };

  /// Piece from point i to the next.
  Piece Between(std::size_t i, const std::vector<double>& slopes) const;
  const Piece& PieceAt(double x) const;
  /// Candidates for the least and the greatest slope.
  std::vector<double> ExtremeSlopes() const;

  std::vector<double> x_;
  std::vector<double> y_;
  /// Linear, cubics between the points, linear: piece i ends at x_[i].
  std::vector<Piece> pieces_;
};

}  // namespace fourpost
