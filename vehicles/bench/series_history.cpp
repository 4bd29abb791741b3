#include "vehicles/bench/series_history.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "vehicles/laws/increasing_root.h"

namespace fourpost {
namespace {

/// Newton's last step: what that leaves is its square over the speeds at which a law bends, of friction 2 mm/s or so,
/// less than 1e-9 m/s. What the rule itself misses is some 1e-4 of speeds.
constexpr double kClose = 1e-6;  // m/s

/// What is known before a step of h: y1 = known + bend v1 - share u, bend = h^2/12 of the ratio of slopes, share = h/2
/// + bend.
double Known(double h, double y, double ratio, double u, double v0, double a0, double v1, double a1) {
  const double rate = v0 - u;
  return y + 0.5 * h * (rate + v1) + h * h / 12 * (a0 - ratio * rate - a1);
}

/// A bilinear dashpot in line with a linear spring: in closed form, without a division. `start` is what the spring's
/// extension would be at the end of a step without u there; while u keeps its sign, u and the extension are shares of
/// it, and a step is one multiplication and one addition after the other.
class BilinearStepper {
 public:
  BilinearStepper(const SeriesDamper& damper, double step)
      : stiffness_(damper.spring.stiffness), half_(0.5 * step), twelfth_(step * step / 12) {
    for (const int sign : {-1, 0, 1}) {
      const double rate = damper.dashpot.Slope(sign);
      Side& side = sides_[static_cast<std::size_t>(sign + 1)];
      side.ratio = stiffness_ / rate;
      side.bend = twelfth_ * side.ratio;
      side.share = half_ + side.bend;
      side.speed = stiffness_ / (rate + stiffness_ * side.share);
      side.extension = 1 - side.share * side.speed;
      side.carried = side.extension - (half_ - side.bend) * side.speed;
    }
  }

  double force() const { return stiffness_ * extension_; }

  /// To rate v1 and acceleration a1 from v0 and a0.
  void Step(double v0, double a0, double v1, double a1) {
    const Side& slopes = sides_[side_];
    const double start = carried_ + (half_ * (v0 + v1) + twelfth_ * (a0 - a1) + slopes.bend * (v1 - v0));
    if (SideOf(start) == side_) {
      extension_ = slopes.extension * start;
      carried_ = slopes.carried * start;
    } else {
      Turn(start - slopes.bend * v1, v1);
    }
  }

 private:
  /// Of compression, rest, rebound: the spring's stiffness over the dashpot's rate, what follows from it, and u, the
  /// extension and what the next step begins with over `start`.
  struct Side {
    double ratio = 0;
    double bend = 0;
    double share = 0;
    double speed = 0;
    double extension = 0;
    double carried = 0;
  };

  /// The dashpot's speed has the sign of the force that it balances; its own slope counts then.
  static std::size_t SideOf(double start) { return start > 0 ? 2 : start < 0 ? 0 : 1; }

  /// Where u changes its sign: with the slopes before, then once more with those there.
  void Turn(double known, double v1) {
    const std::size_t before = side_;
    double speed = Solve(known, v1);
    if (side_ != before) speed = Solve(known, v1);
    carried_ = extension_ - (half_ - sides_[side_].bend) * speed;
  }

  /// u.
  double Solve(double known, double v1) {
    const Side& slopes = sides_[side_];
    const double start = known + slopes.bend * v1;
    const std::size_t side = SideOf(start);
    const double speed = side == side_ ? slopes.speed * start : start / (1 / sides_[side].ratio + slopes.share);
    extension_ = start - slopes.share * speed;
    side_ = side;
    return speed;
  }

  std::array<Side, 3> sides_;
  std::size_t side_ = 1;
  double stiffness_;
  double half_;
  double twelfth_;
  double extension_ = 0;
  /// y0 - (h/2 - bend) u0 with the bend of its side.
  double carried_ = 0;
};

/// The numbers of a bilinear law, for the compiler to see.
class BilinearRates {
 public:
  explicit BilinearRates(const DashpotLaw& law) : compression_(law.Slope(-1)), rebound_(law.Slope(1)) {}

  double Slope(double u) const { return u > 0 ? rebound_ : u < 0 ? compression_ : 0.5 * (compression_ + rebound_); }
  std::pair<double, double> ForceAndSlope(double u) const { return {(u > 0 ? rebound_ : compression_) * u, Slope(u)}; }

 private:
  double compression_;
  double rebound_;
};

/// Any dashpot in line with any spring.
template <typename Dashpot>
class SeriesStepper {
 public:
  SeriesStepper(const SeriesDamper& damper, double step)
      : dashpot_(damper.dashpot), spring_(damper.spring), has_knees_(!damper.spring.knees.empty()), step_(step) {
    Note();
  }

  double force() const { return Tension(extension_); }

  /// To rate v1 and acceleration a1 from v0 and a0.
  void Step(double v0, double a0, double v1, double a1) {
    const double known = Known(step_, extension_, ratio_, speed_, v0, a0, v1, a1);
    // On a stiff spring the dashpot does what both do.
    Solve(known, v1, speed_ + v1 - v0, true);
    Solve(known, v1, speed_, false);
  }

 private:
  /// u where dashpot(u) = spring(start - share u) with the ratio of slopes noted last, from a likely u.
  void Solve(double known, double v1, double likely, bool once) {
    const double bend = step_ * step_ / 12 * ratio_;
    const double start = known + bend * v1;
    const double share = 0.5 * step_ + bend;
    // Between rest and where the spring is slack.
    const auto [lower, upper] = std::minmax({0.0, start / share});
    const auto excess = [&](double u) {
      const double y = start - share * u;
      const auto [force, slope] = dashpot_.ForceAndSlope(u);
      return std::pair(force - Tension(y), slope + share * Stiffness(y));
    };
    const double from = std::clamp(likely, lower, upper);
    if (once) {
      const auto [value, slope] = excess(from);
      speed_ = std::clamp(from - value / slope, lower, upper);
    } else {
      speed_ = IncreasingRoot(excess, 0, lower, upper, from, kClose);
    }
    extension_ = start - share * speed_;
    Note();
  }

  double Tension(double y) const {
    return has_knees_ ? spring_.Force(y) : (spring_.stiffness + spring_.cubic * y * y) * y;
  }

  double Stiffness(double y) const {
    return has_knees_ ? spring_.Slope(y) : spring_.stiffness + 3 * spring_.cubic * y * y;
  }

  /// The ratio of slopes where the damper is.
  void Note() { ratio_ = Stiffness(extension_) / dashpot_.Slope(speed_); }

  Dashpot dashpot_;
  const SpringLaw& spring_;
  bool has_knees_;
  double step_;
  double extension_ = 0;
  double speed_ = 0;
  double ratio_ = 0;
};

template <typename Stepper>
std::vector<double> Forces(Stepper stepper, const BenchMotion& motion) {
  std::vector<double> forces(motion.samples());
  std::size_t k = 0;
  for (std::size_t sample = 1; sample < forces.size(); ++sample) {
    for (std::size_t j = 0; j < motion.steps; ++j, ++k)
      stepper.Step(motion.rate[k], motion.acceleration[k], motion.rate[k + 1], motion.acceleration[k + 1]);
    forces[sample] = stepper.force();
  }
  return forces;
}

}  // namespace

std::vector<double> SeriesForces(const SeriesDamper& damper, const BenchMotion& motion) {
  const bool bilinear = damper.dashpot.IsBilinear();
  if (bilinear && damper.spring.IsLinear()) return Forces<BilinearStepper>({damper, motion.step_s}, motion);
  if (bilinear) return Forces<SeriesStepper<BilinearRates>>({damper, motion.step_s}, motion);
  return Forces<SeriesStepper<const DashpotLaw&>>({damper, motion.step_s}, motion);
}

}  // namespace fourpost
