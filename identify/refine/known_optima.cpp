#include "identify/refine/known_optima.h"

#include <algorithm>
#include <cmath>

namespace fourpost {

namespace {

/// Within three standard deviations by the cost's own curvature.
bool IsNear(const KnownOptimum& known, const Eigen::VectorXd& x, double unit) {
  constexpr double kDeviations = 3;
  const Eigen::VectorXd way = x - known.x;
  return way.dot(known.normal * way) <= kDeviations * kDeviations * unit;
}

}  // namespace

template <typename IsMet>
std::optional<std::size_t> KnownOptima::First(double freedom, const IsMet& is_met) const {
  for (std::size_t i = 0; i < optima_.size(); ++i)
    if (is_met(optima_[i], optima_[i].cost / freedom)) return i;
  return std::nullopt;
}

std::optional<std::size_t> KnownOptima::MetBy(const PointOnTheWay& point, double agreement) const {
  return First(point.freedom, [&](const KnownOptimum& known, double unit) {
    return IsNear(known, point.x, unit) && point.cost >= known.cost &&
           std::abs(point.cost - point.full_gain - known.cost) <= agreement * unit;
  });
}

std::optional<std::size_t> KnownOptima::OneWith(const Eigen::VectorXd& x, double cost, double freedom,
                                                double agreement) const {
  return First(freedom, [&](const KnownOptimum& known, double unit) {
    return IsNear(known, x, unit) && std::abs(cost - known.cost) <= agreement * unit;
  });
}

}  // namespace fourpost
