#include "vehicles/bench/implicit_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "analysis/numerics/increasing_root.h"

namespace fourpost {
namespace {

constexpr std::size_t kStages = 5;
constexpr double kDiagonal = 0.25;
constexpr std::array<double, kStages> kTimes = {1.0 / 4, 3.0 / 4, 11.0 / 20, 1.0 / 2, 1};
/// Below the diagonal. The last row, with the diagonal, is the result.
constexpr std::array<std::array<double, kStages - 1>, kStages> kWeights = {
    {{},
     {1.0 / 2},
     {17.0 / 50, -1.0 / 25},
     {371.0 / 1360, -137.0 / 2720, 15.0 / 544},
     {25.0 / 24, -49.0 / 48, 125.0 / 16, -85.0 / 12}}};
/// Of the result less those of the embedded formula.
constexpr std::array<double, kStages> kErrorWeights = {25.0 / 24 - 59.0 / 48, -49.0 / 48 + 17.0 / 96,
                                                       125.0 / 16 - 225.0 / 32, 0, kDiagonal};

/// Where Newton's method ends [m/s]: what that step leaves is its square over the speeds at which a law bends, of
/// friction some mm/s.
constexpr double kClose = 1e-7;

/// Where friction turns round within a step the embedded formula may miss it by chance; then the stages, which are of
/// lower order, lie far off the cubic through both ends. So much of that counts as an error.
constexpr double kStageShare = 0.01;

/// Through values and slopes at 0 and 1.
struct Cubic {
  double first;
  double last;
  double first_slope;
  double last_slope;

  double At(double t) const {
    const double left = 1 - t;
    return left * left * ((1 + 2 * t) * first + t * first_slope) + t * t * ((3 - 2 * t) * last - left * last_slope);
  }
};

/// Share of a piece of motion below which a step is taken whatever its error: rounding is all that is left there.
constexpr double kShortest = 1e-7;

/// Of the next step over this one, were its error to be `kSafety` of what is allowed.
double Growth(double error, double tolerance) {
  constexpr double kSafety = 0.8;
  constexpr double kLeast = 0.1;
  constexpr double kMost = 4;
  if (!(error > 0)) return kMost;
  return std::clamp(kSafety * std::pow(tolerance / error, 0.25), kLeast, kMost);
}

}  // namespace

/// u where dashpot(u) = spring(start - share u), between rest and where the spring is slack.
double ImplicitSeries::Speed(double start, double share, double likely) const {
  const auto [lower, upper] = std::minmax({0.0, start / share});
  const auto excess = [&](double u) {
    const double y = start - share * u;
    const auto [force, slope] = damper_.dashpot.ForceAndSlope(u);
    return std::pair(force - damper_.spring.Force(y), slope + share * damper_.spring.Slope(y));
  };
  return IncreasingRoot(excess, 0, lower, upper, std::clamp(likely, lower, upper), kClose);
}

ImplicitSeries::Trial ImplicitSeries::Try(const RatePiece& motion, double start, double step) const {
  std::array<double, kStages> extensions;
  std::array<double, kStages> slopes;
  Trial trial{.speed = speed_};
  double rate_before = motion.RateAt(start);
  const double slope_before = rate_before - speed_;
  double error = 0;
  double decay = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kStages; ++i) {
    const double rate = motion.RateAt(start + kTimes[i] * step);
    double known = extension_ + step * kDiagonal * rate;
    for (std::size_t j = 0; j < i; ++j) known += step * kWeights[i][j] * slopes[j];
    // On a stiff spring the dashpot does what both do.
    trial.speed = Speed(known, step * kDiagonal, trial.speed + rate - rate_before);
    extensions[i] = known - step * kDiagonal * trial.speed;
    slopes[i] = rate - trial.speed;
    error += kErrorWeights[i] * slopes[i];
    decay = std::min(decay, damper_.spring.Slope(extensions[i]) / damper_.dashpot.Slope(trial.speed));
    rate_before = rate;
  }
  trial.extension = extensions.back();
  // As a stage would damp it where the spring is stiff throughout: what decays within the step is no error of its end.
  error = step * std::abs(error) / (1 + kDiagonal * step * decay);
  const Cubic path{extension_, trial.extension, step * slope_before, step * slopes.back()};
  for (std::size_t i = 0; i + 1 < kStages; ++i)
    error = std::max(error, kStageShare * std::abs(extensions[i] - path.At(kTimes[i])));
  trial.error = damper_.spring.Slope(trial.extension) * error;
  return trial;
}

void ImplicitSeries::Advance(const RatePiece& motion) {
  for (double done = 0; done < 1;) {
    const double share = std::min(share_, 1 - done);
    const Trial trial = Try(motion, done * motion.duration_s, share * motion.duration_s);
    const bool taken = !(trial.error > tolerance_N_) || share <= kShortest;
    // A step cut short by the end of the piece says nothing of how long one may be, unless it failed.
    const double next = share * Growth(trial.error, tolerance_N_);
    share_ = taken && share < share_ ? std::max(share_, std::min(next, 1.0)) : std::clamp(next, kShortest, 1.0);
    if (!taken) continue;
    extension_ = trial.extension;
    speed_ = trial.speed;
    done = 1 - done - share < kShortest ? 1 : done + share;
  }
}

}  // namespace fourpost
