#include "analysis/signals/slow_drift.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "analysis/signals/deviation.h"

namespace fourpost {
namespace {

constexpr Eigen::Index kWindows = 19;

/// By window.
struct Levels {
  Eigen::VectorXd level = Eigen::VectorXd::Zero(kWindows);
  /// Deviations from it, and of the steps between samples.
  Eigen::VectorXd size = Eigen::VectorXd::Zero(kWindows);
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(kWindows);
};

Levels LevelsOf(std::span<const double> signal, std::size_t length) {
  std::vector<double> weights(length);
  for (std::size_t k = 0; k < length; ++k)
    weights[k] = (1 - std::cos(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(length))) /
                 static_cast<double>(length);
  Levels levels;
  for (Eigen::Index w = 0; w < kWindows; ++w) {
    const std::span<const double> part = signal.subspan(static_cast<std::size_t>(w) * (length / 2), length);
    for (std::size_t k = 0; k < length; ++k) levels.level[w] += weights[k] * part[k];
    for (std::size_t k = 0; k < length; ++k) levels.size[w] += weights[k] * std::pow(part[k] - levels.level[w], 2);
    for (std::size_t k = 1; k < length; ++k) levels.rate[w] += weights[k] * std::pow(part[k] - part[k - 1], 2);
  }
  levels.size = levels.size.cwiseSqrt();
  levels.rate = levels.rate.cwiseSqrt();
  return levels;
}

/// What of a vector the columns do not explain.
Eigen::VectorXd Beside(const Eigen::MatrixXd& columns, const Eigen::VectorXd& vector) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(1e-6);
  return vector - columns * qr.solve(vector);
}

double WithLargestOne(double value, double largest) { return largest > 0 ? value / largest : 0; }

/// The correlation of neighbours, at least 0 and at most 0.9.
double Correlation(const Eigen::VectorXd& rest) {
  const double all = rest.squaredNorm();
  return all > 0 ? std::clamp(rest.tail(kWindows - 1).dot(rest.head(kWindows - 1)) / all, 0.0, 0.9) : 0;
}

}  // namespace

std::optional<double> SlowDrift(std::span<const double> signal) {
  constexpr std::size_t kShortest = 32;
  constexpr double kCertain = 10;
  constexpr double kOfDeviation = 0.03;
  /// Of the squares of time, beside the motion's size and rate.
  constexpr double kOfTime = 0.5;
  const std::size_t length = 2 * (signal.size() / static_cast<std::size_t>(kWindows + 1));
  if (length < kShortest) return std::nullopt;
  const Levels levels = LevelsOf(signal, length);
  if (!levels.level.allFinite()) return std::nullopt;
  Eigen::VectorXd time(kWindows);
  // From begin to end of the record 1.
  for (Eigen::Index w = 0; w < kWindows; ++w)
    time[w] =
        static_cast<double>(w - kWindows / 2) * static_cast<double>(length / 2) / static_cast<double>(signal.size());
  Eigen::MatrixXd others(kWindows, 4);
  for (Eigen::Index w = 0; w < kWindows; ++w)
    others.row(w) << 1, time[w] * time[w], WithLargestOne(levels.size[w], levels.size.maxCoeff()),
        WithLargestOne(levels.rate[w], levels.rate.maxCoeff());
  const Eigen::VectorXd own_time = Beside(others, time);
  if (own_time.squaredNorm() < kOfTime * time.squaredNorm()) return std::nullopt;
  const Eigen::VectorXd level = Beside(others, levels.level);
  const double drift = own_time.dot(level) / own_time.squaredNorm();
  const Eigen::VectorXd rest = level - drift * own_time;
  const double r = Correlation(rest);
  const double freedom = static_cast<double>(kWindows - 1 - others.cols());
  const double sd = std::sqrt(rest.squaredNorm() / freedom * (1 + r) / (1 - r) / own_time.squaredNorm());
  if (!(std::abs(drift) > kCertain * sd) || !(std::abs(drift) > kOfDeviation * DeviationOf(signal)))
    return std::nullopt;
  return drift;
}

}  // namespace fourpost
