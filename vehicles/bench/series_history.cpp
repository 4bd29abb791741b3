#include "vehicles/bench/series_history.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "vehicles/laws/increasing_root.h"

namespace fourpost {
namespace {

/// Of speeds of the dashpot: what the rule itself misses is some 1e-4 of them.
constexpr double kClose = 1e-9;  // m/s

/// The damper from one step to the next.
class SeriesStepper {
 public:
  SeriesStepper(const SeriesDamper& damper, double step)
      : dashpot_(damper.dashpot), spring_(damper.spring), linear_(spring_.IsLinear()), step_(step) {
    const std::vector<DashpotLaw::Kink> kinks = dashpot_.Kinks();
    bilinear_ = kinks.size() == 1 && std::isinf(dashpot_.StepSpeed());
    if (bilinear_) rates_ = {dashpot_.Slope(-1), dashpot_.Slope(0), dashpot_.Slope(1)};
    Note();
  }

  double force() const { return linear_ ? spring_.stiffness * extension_ : spring_.Force(extension_); }

  /// To rate v1 and acceleration a1 from v0 and a0.
  void Step(double v0, double a0, double v1, double a1) {
    const double rate = v0 - speed_;
    const double known = extension_ + 0.5 * step_ * (rate + v1) + step_ * step_ / 12 * (a0 - ratio_ * rate - a1);
    double ratio = ratio_;
    Find(known, ratio, v1);
    Note();
    if (ratio_ == ratio) return;
    ratio = ratio_;
    Find(known, ratio, v1);
    Note();
  }

 private:
  /// Speed and extension at the end of the step; `ratio`: of the slopes there.
  void Find(double known, double ratio, double v1) {
    const double bend = step_ * step_ / 12 * ratio;
    const double start = known + bend * v1;
    const double share = 0.5 * step_ + bend;
    speed_ = linear_ && bilinear_ ? spring_.stiffness * start / (Rate(start) + spring_.stiffness * share)
                                  : Balance(start, share);
    extension_ = start - share * speed_;
  }

  /// u where dashpot(u) = spring(start - share u): between rest and where the spring is slack.
  double Balance(double start, double share) const {
    const double slack = start / share;
    const auto excess = [&](double u) {
      const double y = start - share * u;
      return std::pair(dashpot_.Force(u) - spring_.Force(y), Rate(u) + share * spring_.Slope(y));
    };
    const auto [lower, upper] = std::minmax(0.0, slack);
    return IncreasingRoot(excess, 0, lower, upper, std::clamp(speed_, lower, upper), kClose);
  }

  /// Slope of the dashpot.
  double Rate(double u) const {
    if (!bilinear_) return dashpot_.Slope(u);
    return u == 0 ? rates_[1] : rates_[u > 0 ? 2 : 0];
  }

  /// The ratio of slopes where the damper is.
  void Note() {
    const double stiffness = linear_ ? spring_.stiffness : spring_.Slope(extension_);
    ratio_ = stiffness / Rate(speed_);
  }

  const DashpotLaw& dashpot_;
  const SpringLaw& spring_;
  bool linear_;
  double step_;
  bool bilinear_ = false;
  /// Of a bilinear dashpot: in compression, at rest, in rebound.
  std::array<double, 3> rates_{};
  double extension_ = 0;
  double speed_ = 0;
  double ratio_ = 0;
};

}  // namespace

std::vector<double> SeriesForces(const SeriesDamper& damper, const BenchMotion& motion) {
  std::vector<double> forces(motion.samples());
  if (forces.empty()) return forces;
  SeriesStepper stepper(damper, motion.step_s);
  std::size_t k = 0;
  for (std::size_t sample = 1; sample < forces.size(); ++sample) {
    for (std::size_t j = 0; j < motion.steps; ++j, ++k)
      stepper.Step(motion.rate[k], motion.acceleration[k], motion.rate[k + 1], motion.acceleration[k + 1]);
    forces[sample] = stepper.force();
  }
  return forces;
}

}  // namespace fourpost
