#include "vehicles/bench/force_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/QR>

#include "analysis/deviation.h"
#include "analysis/turning_points.h"

namespace fourpost {

double ShareOfMotion(std::span<const double> x, std::span<const double> v, std::span<const double> force) {
  const auto count = static_cast<Eigen::Index>(force.size());
  const Eigen::Map<const Eigen::ArrayXd> displacement(x.data(), count);
  const Eigen::Map<const Eigen::ArrayXd> rate(v.data(), count);
  Eigen::MatrixXd motion(count, 5);
  motion << Eigen::ArrayXd::Ones(count), displacement, rate, rate.abs(), rate.sign();
  // Columns alike in size.
  for (Eigen::Index j = 0; j < motion.cols(); ++j)
    if (const double size = motion.col(j).norm(); size > 0) motion.col(j) /= size;
  const Eigen::VectorXd wanted = Eigen::Map<const Eigen::VectorXd>(force.data(), count).array() - Mean(force);
  const double variance = wanted.squaredNorm();
  if (variance == 0) return 0;
  const Eigen::VectorXd left = wanted - motion * motion.colPivHouseholderQr().solve(wanted);
  return 1 - left.squaredNorm() / variance;
}

MotionPhase PhaseOf(std::span<const double> x, std::span<const double> force, double step_s) {
  const double x_mean = Mean(x);
  const double force_mean = Mean(force);
  double squares = 0;
  double rate_squares = 0;
  double stored = 0;
  double dissipated = 0;
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const double v = (x[k + 1] - x[k - 1]) / (2 * step_s);
    squares += std::pow(x[k] - x_mean, 2);
    rate_squares += v * v;
    stored += (force[k] - force_mean) * (x[k] - x_mean);
    dissipated += (force[k] - force_mean) * v;
  }
  const double w = std::sqrt(rate_squares / squares);
  return {.frequency_Hz = w / (2 * std::numbers::pi),
          .phase_deg = std::atan2(dissipated / rate_squares * w, stored / squares) * 180 / std::numbers::pi};
}

std::optional<MotionPhase> PhaseOfFastest(std::span<const double> x, std::span<const double> force, double step_s) {
  constexpr std::size_t kFewestSamples = 8;
  const std::vector<std::size_t> turns = TurningPoints(x);
  std::vector<MotionPhase> cycles;
  for (std::size_t i = 2; i < turns.size(); ++i) {
    const std::size_t count = turns[i] - turns[i - 2] + 1;
    if (count >= kFewestSamples)
      cycles.push_back(PhaseOf(x.subspan(turns[i - 2], count), force.subspan(turns[i - 2], count), step_s));
  }
  if (cycles.empty()) return std::nullopt;
  std::sort(cycles.begin(), cycles.end(),
            [](const MotionPhase& a, const MotionPhase& b) { return a.frequency_Hz > b.frequency_Hz; });
  cycles.resize((cycles.size() + 3) / 4);
  const auto middle = cycles.begin() + static_cast<std::ptrdiff_t>(cycles.size() / 2);
  std::nth_element(cycles.begin(), middle, cycles.end(),
                   [](const MotionPhase& a, const MotionPhase& b) { return a.phase_deg < b.phase_deg; });
  return *middle;
}

}  // namespace fourpost
