#include "identify/uncertainty/truncated_normal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fourpost {
namespace {

/// Between limits that are near to each other.
double DrawByUniform(double lower, double upper, Draws& draws) {
  // Where the density is highest.
  const double top = lower > 0 ? lower : upper < 0 ? upper : 0;
  while (true) {
    const double x = lower + (upper - lower) * draws.Uniform();
    if (draws.Uniform() < std::exp((top * top - x * x) / 2)) return x;
  }
}

/// Beyond a lower limit above zero.
double DrawByExponential(double lower, double upper, Draws& draws) {
  const double rate = (lower + std::sqrt(lower * lower + 4)) / 2;
  while (true) {
    const double x = lower - std::log1p(-draws.Uniform()) / rate;
    if (x <= upper && draws.Uniform() < std::exp(-(x - rate) * (x - rate) / 2)) return x;
  }
}

double DrawByNormal(double lower, double upper, Draws& draws) {
  while (true) {
    const double x = draws.Normal();
    if (lower <= x && x <= upper) return x;
  }
}

}  // namespace

double DrawNormalBetween(double lower, double upper, Draws& draws) {
  if (upper <= 0) return -DrawNormalBetween(-upper, -lower, draws);
  const double wide = lower > 0 ? 1 / lower : std::sqrt(2 * std::numbers::pi);
  if (upper - lower < wide) return DrawByUniform(lower, upper, draws);
  return lower > 0 ? DrawByExponential(lower, upper, draws) : DrawByNormal(lower, upper, draws);
}

Eigen::VectorXd DrawNormalWithin(const Eigen::VectorXd& centre, const Eigen::MatrixXd& root,
                                 const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Draws& draws) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const Eigen::Index steps = 30 * root.cols();
  Eigen::VectorXd standard = Eigen::VectorXd::Zero(root.cols());
  Eigen::VectorXd at = centre;
  Eigen::VectorXd line(root.cols());
  for (Eigen::Index step = 0; step < steps; ++step) {
    for (double& component : line) component = draws.Normal();
    line.normalize();
    const Eigen::VectorXd along = root * line;
    double first = -kInfinite;
    double last = kInfinite;
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      if (along[j] == 0) continue;
      const double to_lower = (lower[j] - at[j]) / along[j];
      const double to_upper = (upper[j] - at[j]) / along[j];
      first = std::max(first, std::min(to_lower, to_upper));
      last = std::min(last, std::max(to_lower, to_upper));
    }
    if (!(first < last)) continue;
    const double middle = standard.dot(line);
    const double length = DrawNormalBetween(first + middle, last + middle, draws) - middle;
    standard += length * line;
    at = (centre + root * standard).cwiseMax(lower).cwiseMin(upper);  // to the last bit
  }
  return at;
}

}  // namespace fourpost
