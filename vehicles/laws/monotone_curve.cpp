#include "vehicles/laws/monotone_curve.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "analysis/numerics/increasing_root.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

void RequireFinite(const std::vector<double>& values, const std::string& name) {
  for (const double value : values) RequireOption(std::isfinite(value), name, value, "finite");
}

template <typename Order>
void RequireOrder(const std::vector<double>& values, const std::string& name, Order is_good, const std::string& bound) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    std::ostringstream text;
    text << bound << " the one before, " << values[i - 1];
    RequireOption(is_good(values[i - 1], values[i]), name, values[i], text.str());
  }
}

std::vector<double> Chords(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> chords;
  for (std::size_t i = 1; i < x.size(); ++i) chords.push_back((y[i] - y[i - 1]) / (x[i] - x[i - 1]));
  return chords;
}

std::vector<double> SlopesAtPoints(const std::vector<double>& x, const std::vector<double>& chords) {
  std::vector<double> slopes = {chords.front()};
  for (std::size_t i = 1; i < chords.size(); ++i) {
    const double left = x[i] - x[i - 1];
    const double right = x[i + 1] - x[i];
    slopes.push_back((right * chords[i - 1] + left * chords[i]) / (left + right));
  }
  slopes.push_back(chords.back());
  return slopes;
}

/// Reduces slopes until both of each piece, over its chord, lie within a circle of radius 3. Reducing one leaves the
/// pieces before within theirs.
void MakeMonotone(std::vector<double>& slopes, const std::vector<double>& chords) {
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const double radius = std::hypot(slopes[i], slopes[i + 1]);
    if (radius <= 3 * chords[i]) continue;
    slopes[i] *= 3 * chords[i] / radius;
    slopes[i + 1] *= 3 * chords[i] / radius;
  }
}

}  // namespace

MonotoneCurve::MonotoneCurve(std::vector<double> x, std::vector<double> y, const std::string& x_name,
                             const std::string& y_name)
    : x_(std::move(x)), y_(std::move(y)) {
  RequireOption(x_.size() >= 2, x_name + ": number of points", x_.size(), "at least 2");
  RequireOption(y_.size() == x_.size(), y_name + ": number of points", y_.size(), "that of " + x_name);
  RequireFinite(x_, x_name);
  RequireFinite(y_, y_name);
  RequireOrder(x_, x_name, std::less<>(), "above");
  RequireOrder(y_, y_name, std::less_equal<>(), "not below");
  const std::vector<double> chords = Chords(x_, y_);
  std::vector<double> slopes = SlopesAtPoints(x_, chords);
  MakeMonotone(slopes, chords);
  pieces_.push_back({x_.front(), y_.front(), slopes.front(), 0, 0});
  for (std::size_t i = 0; i < chords.size(); ++i) pieces_.push_back(Between(i, slopes));
  pieces_.push_back({x_.back(), y_.back(), slopes.back(), 0, 0});
}

MonotoneCurve::Piece MonotoneCurve::Between(std::size_t i, const std::vector<double>& slopes) const {
  const bool right_is_nearer = std::abs(x_[i + 1]) < std::abs(x_[i]);
  const std::size_t near = right_is_nearer ? i + 1 : i;
  const std::size_t far = right_is_nearer ? i : i + 1;
  const double width = x_[far] - x_[near];
  const double chord = (y_[far] - y_[near]) / width;
  return {x_[near], y_[near], slopes[near], (3 * chord - 2 * slopes[near] - slopes[far]) / width,
          (slopes[near] + slopes[far] - 2 * chord) / (width * width)};
}

const MonotoneCurve::Piece& MonotoneCurve::PieceAt(double x) const {
  return pieces_[static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin())];
}

double MonotoneCurve::Value(double x) const {
  const Piece& piece = PieceAt(x);
  return piece.y0 + piece.Rise(x - piece.x0);
}

double MonotoneCurve::Slope(double x) const {
  const Piece& piece = PieceAt(x);
  return piece.SlopeAt(x - piece.x0);
}

double MonotoneCurve::Integral(double x) const {
  const double lower = std::min(0.0, x);
  const double upper = std::max(0.0, x);
  double area = std::isnan(x) ? x : 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const double from = i == 0 ? lower : std::max(lower, x_[i - 1]);
    const double to = i == x_.size() ? upper : std::min(upper, x_[i]);
    if (from < to) area += piece.Area(to - piece.x0) - piece.Area(from - piece.x0);
  }
  return x < 0 ? -area : area;
}

double MonotoneCurve::Argument(double y) const {
  const auto i = static_cast<std::size_t>(std::upper_bound(y_.begin(), y_.end(), y) - y_.begin());
  const Piece& piece = pieces_[i];
  const double rise = y - piece.y0;
  if (i == 0 || i == x_.size()) return piece.x0 + rise / piece.slope;
  const auto curve = [&](double e) { return std::pair(piece.Rise(e), piece.SlopeAt(e)); };
  const double lower = x_[i - 1] - piece.x0;
  const double upper = x_[i] - piece.x0;
  return piece.x0 + IncreasingRoot(curve, rise, lower, upper, (upper - lower) / (y_[i] - y_[i - 1]) * rise);
}

double MonotoneCurve::LeastSlope() const {
  const std::vector<double> slopes = ExtremeSlopes();
  return *std::min_element(slopes.begin(), slopes.end());
}

double MonotoneCurve::GreatestSlope() const {
  const std::vector<double> slopes = ExtremeSlopes();
  return *std::max_element(slopes.begin(), slopes.end());
}

std::vector<double> MonotoneCurve::ExtremeSlopes() const {
  std::vector<double> slopes;
  for (const Piece& piece : pieces_) slopes.push_back(piece.slope);
  for (std::size_t i = 1; i < x_.size(); ++i) {
    // A cubic's slope is a parabola.
    const Piece& piece = pieces_[i];
    const double vertex = -piece.quadratic / (3 * piece.cubic);
    if (piece.x0 + vertex > x_[i - 1] && piece.x0 + vertex < x_[i]) slopes.push_back(piece.SlopeAt(vertex));
  }
  return slopes;
}

}  // namespace fourpost
