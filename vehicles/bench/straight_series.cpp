#include "vehicles/bench/straight_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fourpost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// phi_k(z) = integral over s from 0 to 1 of exp((1 - s) z) s^(k-1) / (k-1)! for k = 1, 2, 3, z <= 0.
std::array<double, 3> Phis(double z) {
  // Where the recursion would lose more digits than the series leaves out.
  constexpr double kSmall = 0.5;
  if (std::abs(z) < kSmall) {
    double third = 0;
    // z^n / (n + 3)! from behind; 0.5^14 / 17! is beyond rounding.
    for (int n = 14; n > 0; --n) third = z / (n + 3) * (1 + third);
    third = (1 + third) / 6;
    const double second = 0.5 + z * third;
    return {1 + z * second, second, third};
  }
  const double first = std::expm1(z) / z;
  const double second = (first - 1) / z;
  return {first, second, (second - 0.5) / z};
}

/// Where f changes its sign between two times, to rounding: regula falsi, Illinois.
template <typename Function>
double Crossing(const Function& f, double lower, double upper) {
  constexpr int kMost = 60;
  double at_lower = f(lower);
  double at_upper = f(upper);
  const double close = 4 * std::numeric_limits<double>::epsilon() * upper;
  int side = 0;
  for (int i = 0; i < kMost && upper - lower > close; ++i) {
    double t = (lower * at_upper - upper * at_lower) / (at_upper - at_lower);
    if (!(t > lower && t < upper)) t = 0.5 * (lower + upper);
    const double value = f(t);
    if (value == 0) return t;
    if ((value > 0) == (at_upper > 0)) {
      upper = t;
      at_upper = value;
      if (side == 1) at_lower /= 2;
      side = 1;
    } else {
      lower = t;
      at_lower = value;
      if (side == -1) at_upper /= 2;
      side = -1;
    }
  }
  return upper;
}

}  // namespace

bool StraightSeries::Holds(const SeriesDamper& damper) {
  return damper.dashpot.IsStraight() && damper.dashpot.LeastRate() > 0 && damper.spring.IsLinear();
}

StraightSeries::StraightSeries(const SeriesDamper& damper, double usual_s)
    : stiffness_(damper.spring.stiffness), usual_s_(usual_s) {
  std::vector<double> ends = {-kInfinity};
  for (const DashpotLaw::Kink& kink : damper.dashpot.Kinks()) ends.push_back(kink.speed);
  ends.push_back(kInfinity);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i] < 0) piece_ = i;  // the last that begins below rest holds it
    const double inside = std::isinf(ends[i])       ? ends[i + 1] - 1
                          : std::isinf(ends[i + 1]) ? ends[i] + 1
                                                    : 0.5 * (ends[i] + ends[i + 1]);
    const auto [force, slope] = damper.dashpot.ForceAndSlope(inside);
    const auto force_at = [&](double u) { return std::isinf(u) ? u : damper.dashpot.Force(u); };
    Piece piece{force_at(ends[i]), force_at(ends[i + 1]), force - slope * inside, slope, {}};
    piece.usual = WeightsOf(piece, usual_s);
    pieces_.push_back(piece);
  }
}

StraightSeries::Weights StraightSeries::WeightsOf(const Piece& piece, double t) const {
  const double z = -stiffness_ / piece.slope * t;
  const auto [first, second, third] = Phis(z);
  const double step = stiffness_ * t;
  return {std::exp(z), step * first, step * t * second, step * t * t * third};
}

double StraightSeries::ForceAt(const RatePiece& motion, double t) const {
  const Piece& piece = pieces_[piece_];
  const auto force = [&](const Weights& weights) {
    return piece.offset + weights.start * (force_ - piece.offset) + weights.rate * motion.rate +
           weights.acceleration * motion.acceleration + weights.jerk * motion.jerk;
  };
  return t == usual_s_ ? force(piece.usual) : force(WeightsOf(piece, t));
}

double StraightSeries::Trend(const Piece& piece, double force, double rate) const {
  return stiffness_ * (rate - (force - piece.offset) / piece.slope);
}

/// From the end of a piece the force goes on to the side that it tends to.
void StraightSeries::EnterPieceOf(const RatePiece& motion) {
  const Piece& here = pieces_[piece_];
  if (force_ > here.lower && force_ < here.upper) return;
  const double trend = Trend(here, force_, motion.rate);
  const double turn = trend != 0 ? trend : motion.acceleration;
  if (force_ >= here.upper && turn > 0) ++piece_;
  if (force_ <= here.lower && turn < 0) --piece_;
}

double StraightSeries::TimeWithin(const RatePiece& motion, double end) const {
  const Piece& piece = pieces_[piece_];
  const double duration = motion.duration_s;
  const double trend = Trend(piece, force_, motion.rate);
  const double last_trend = Trend(piece, end, motion.RateAt(duration));
  const auto is_out = [&](double force) { return force > piece.upper || force < piece.lower; };
  const auto exit = [&](double from, double to, double force) {
    const double bound = force > piece.upper ? piece.upper : piece.lower;
    return Crossing([&](double t) { return ForceAt(motion, t) - bound; }, from, to);
  };
  // It turns round on the way, perhaps beyond the end of the piece.
  double turn = 0;
  const double bound = trend > 0 ? piece.upper : piece.lower;
  const bool may_leave = std::abs(bound - force_) < duration * (std::abs(trend) + std::abs(last_trend)) || is_out(end);
  if ((trend > 0) != (last_trend > 0) && may_leave) {
    turn = Crossing([&](double t) { return Trend(piece, ForceAt(motion, t), motion.RateAt(t)); }, 0, duration);
    const double furthest = ForceAt(motion, turn);
    if (is_out(furthest)) return exit(0, turn, furthest);
  }
  return is_out(end) ? exit(turn, duration, end) : duration;
}

void StraightSeries::Advance(const RatePiece& motion) {
  RatePiece left = motion;
  EnterPieceOf(left);
  while (true) {
    const Piece& piece = pieces_[piece_];
    const double end = ForceAt(left, left.duration_s);
    const double time = TimeWithin(left, end);
    if (time >= left.duration_s) {
      force_ = end;
      return;
    }
    const double reached = ForceAt(left, time);
    const bool upwards = std::abs(piece.upper - reached) < std::abs(piece.lower - reached);
    force_ = upwards ? piece.upper : piece.lower;
    piece_ += upwards ? 1 : -1;
    left = left.From(time);
  }
}

}  // namespace fourpost
