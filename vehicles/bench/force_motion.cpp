#include "vehicles/bench/force_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/turning_points.h"

namespace fourpost {

namespace {

/// 1, x, direction of v, v, |v| at each sample, columns alike in size.
Eigen::MatrixXd MotionTerms(std::span<const double> x, std::span<const double> v) {
  const auto count = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const Eigen::ArrayXd> displacement(x.data(), count);
  const Eigen::Map<const Eigen::ArrayXd> rate(v.data(), count);
  Eigen::MatrixXd motion(count, 5);
  motion << Eigen::ArrayXd::Ones(count), displacement, rate.sign(), rate, rate.abs();
  for (Eigen::Index j = 0; j < motion.cols(); ++j)
    if (const double size = motion.col(j).norm(); size > 0) motion.col(j) /= size;
  return motion;
}

/// Without its mean.
Eigen::VectorXd Centred(std::span<const double> force) {
  return Eigen::Map<const Eigen::VectorXd>(force.data(), static_cast<Eigen::Index>(force.size())).array() - Mean(force);
}

}  // namespace

double ShareOfMotion(std::span<const double> x, std::span<const double> v, std::span<const double> force) {
  const Eigen::MatrixXd motion = MotionTerms(x, v);
  const Eigen::VectorXd wanted = Centred(force);
  const double variance = wanted.squaredNorm();
  if (variance == 0) return 0;
  const Eigen::VectorXd left = wanted - motion * LeastSquares(motion, wanted);
  return 1 - left.squaredNorm() / variance;
}

ForceSides SidesOf(std::span<const double> x, std::span<const double> v, std::span<const double> force) {
  const Eigen::MatrixXd motion = MotionTerms(x, v);
  const Eigen::VectorXd wanted = Centred(force);
  const auto alike = motion.leftCols(4);
  const Eigen::VectorXd terms = LeastSquares(motion, wanted);
  const double left = (wanted - motion * terms).squaredNorm();
  const double left_alike = (wanted - alike * LeastSquares(alike, wanted)).squaredNorm();
  if (left_alike == 0) return {};
  // What both sides take, and what rebound takes more.
  const Eigen::Map<const Eigen::VectorXd> rate(v.data(), static_cast<Eigen::Index>(v.size()));
  const double both = rate.dot(motion.middleCols(2, 2) * terms.segment(2, 2));
  const double more = terms[4] * rate.cwiseAbs().dot(motion.col(4));
  if (both <= std::abs(more)) return {};
  return {.compression_over_rebound = (both - more) / (both + more), .share = 1 - left / left_alike};
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
