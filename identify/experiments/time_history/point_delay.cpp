#include "identify/experiments/time_history/point_delay.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/signals/fit_quality.h"
#include "analysis/signals/signal_timing.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// h, see PointDelays: what sensors of displacement add as noise falls with its square, what it hides is above 25 Hz.
constexpr double kReach_s = 0.02;

bool AreOfOnePoint(const Sensor& displacement, const Sensor& acceleration) {
  constexpr double kApart_m = 0.01;
  constexpr double kAlong = 0.999;
  return displacement.type == Sensor::Type::kDisplacement && acceleration.type == Sensor::Type::kAccelerometer &&
         displacement.point.link == acceleration.point.link &&
         (displacement.point.xyz - acceleration.point.xyz).norm() < kApart_m &&
         displacement.axis.dot(acceleration.axis) > kAlong;
}

/// Samples reach to size - 1 - reach.
Eigen::VectorXd SecondDifference(const Eigen::VectorXd& z, Index reach, double rate_Hz) {
  const Index count = z.size() - 2 * reach;
  return std::pow(rate_Hz / static_cast<double>(reach), 2) *
         (z.tail(count) - 2 * z.segment(reach, count) + z.head(count));
}

Eigen::VectorXd UnderTriangle(const Eigen::VectorXd& a, Index reach) {
  const Index count = a.size() - 2 * reach;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(count);
  for (Index s = -reach; s <= reach; ++s) sum += static_cast<double>(reach - std::abs(s)) * a.segment(reach + s, count);
  return sum / static_cast<double>(reach * reach);
}

/// Nothing where they are together, or where the data do not show it.
std::optional<double> DelayOf(const Eigen::VectorXd& z, const Eigen::VectorXd& a, double rate_Hz) {
  constexpr Index kFewest = 64;
  // What a delay leaves is noise, of any other fault it is more.
  constexpr double kMostLeft_percent = 25;
  constexpr double kShareLeft = 0.25;
  const Index reach = std::max<Index>(1, std::lround(kReach_s * rate_Hz));
  if (z.size() < 2 * reach + kFewest) return std::nullopt;
  const Eigen::VectorXd second = WithoutMean(SecondDifference(z, reach, rate_Hz));
  const Eigen::VectorXd mean = WithoutMean(UnderTriangle(a, reach));
  const SignalTiming timing = TimingOf(second, mean, rate_Hz);
  const double apart = NormalisedMse_percent({second.data(), static_cast<std::size_t>(second.size())},
                                             {mean.data(), static_cast<std::size_t>(mean.size())});
  if (!(std::abs(timing.delay_s) * rate_Hz > 1 && timing.gain > 0 && timing.nmse_percent < kMostLeft_percent &&
        timing.nmse_percent < kShareLeft * apart))
    return std::nullopt;
  return timing.delay_s;
}

}  // namespace

std::vector<PointDelay> PointDelays(const Vehicle& vehicle, const MeasuredHistory& history) {
  std::vector<PointDelay> delays;
  for (std::size_t z = 0; z < history.signals.size(); ++z)
    for (std::size_t a = 0; a < history.signals.size(); ++a) {
      const MeasuredSignal& displacement = history.signals[z];
      const MeasuredSignal& acceleration = history.signals[a];
      if (!AreOfOnePoint(vehicle.sensors[displacement.sensor], vehicle.sensors[acceleration.sensor])) continue;
      if (const auto delay = DelayOf(displacement.values, acceleration.values, history.rate_Hz))
        delays.push_back({z, a, *delay});
    }
  return delays;
}

}  // namespace fourpost
