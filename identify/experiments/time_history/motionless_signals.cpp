#include "identify/experiments/time_history/motionless_signals.h"

#include <algorithm>
#include <cmath>

#include "analysis/signals/motionless.h"
#include "analysis/text/short_number.h"

namespace fourpost {
namespace {

/// What the posts' motion alone moves sensors of this unit by, for one that is the only one of its kind. Turning by
/// the largest distance between posts of a road vehicle, of which it is less than for any other.
double SizeByPosts(const std::string& unit, const MeasuredHistory& history) {
  constexpr double kLongest_m = 10;
  double height_m = 0;
  double speed = 0;
  for (const std::vector<double>& heights : history.heights) {
    if (heights.size() < 2) continue;
    const Eigen::Map<const Eigen::VectorXd> z(heights.data(), std::ssize(heights));
    const Eigen::VectorXd slope = history.rate_Hz * (z.tail(z.size() - 1) - z.head(z.size() - 1));
    height_m = std::max(height_m, std::sqrt((z.array() - z.mean()).square().mean()));
    speed = std::max(speed, std::sqrt(slope.squaredNorm() / static_cast<double>(slope.size())));
  }
  if (unit == "m") return height_m;
  if (unit == "m/s") return speed;
  if (unit == "rad") return height_m / kLongest_m;
  return unit == "rad/s" ? speed / kLongest_m : 0;
}

}  // namespace

void FindLoudest(std::vector<MeasuredSignal>& signals) {
  for (MeasuredSignal& signal : signals)
    for (const MeasuredSignal& other : signals)
      if (other.unit == signal.unit) signal.loudest = std::max(signal.loudest, other.Deviation());
}

std::vector<MotionlessSignal> TakeMotionless(MeasuredHistory& history) {
  std::vector<MotionlessSignal> taken;
  std::erase_if(history.signals, [&](const MeasuredSignal& signal) {
    const double rms = signal.Deviation();
    const double largest = std::max(signal.loudest, SizeByPosts(signal.unit, history));
    if (rms == 0 || rms >= kMotionlessShare * largest) return false;
    taken.push_back({.name = signal.name,
                     .rms = ShortNumber(rms, 2) + " " + signal.unit,
                     .largest_rms = ShortNumber(largest, 2) + " " + signal.unit,
                     .line = signal.source.line});
    return true;
  });
  return taken;
}

}  // namespace fourpost
