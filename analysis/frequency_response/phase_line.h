#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

namespace fourpost {

/// Straight line through phases, from sums about the first point.
class PhaseLine {
 public:
  explicit PhaseLine(double origin) : origin_(origin) {}

  void Add(double time, double phase) {
    const double t = time - origin_;
    ++count_;
    t_ += t;
    p_ += phase;
    tt_ += t * t;
    tp_ += t * phase;
  }

  std::size_t count() const { return count_; }
  double slope() const {
    const double n = static_cast<double>(count_);
    return (n * tp_ - t_ * p_) / (n * tt_ - t_ * t_);
  }
  double At(double time) const {
    const double n = static_cast<double>(count_);
    return (p_ - slope() * t_) / n + slope() * (time - origin_);
  }

 private:
  double origin_;
  std::size_t count_ = 0;
  double t_ = 0;
  double p_ = 0;
  double tt_ = 0;
  double tp_ = 0;
};

/// The turn of `phase` that is nearest to `expected`.
inline double Unwrapped(double phase, double expected) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return phase + kTurn * std::round((expected - phase) / kTurn);
}

}  // namespace fourpost
