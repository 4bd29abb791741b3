#include "identify/refine/known_optima.h"

#include <algorithm>
#include <cmath>

namespace fourpost {

std::optional<std::size_t> KnownOptima::MetBy(const PointOnTheWay& point, double agreement) const {
  constexpr double kDeviations = 3;
  const auto met = std::find_if(optima_.begin(), optima_.end(), [&](const KnownOptimum& known) {
    const double unit = known.cost / point.freedom;
    const Eigen::VectorXd way = point.x - known.x;
    const bool is_near = way.dot(known.normal * way) <= kDeviations * kDeviations * unit;
    return is_near && point.cost >= known.cost - agreement * unit &&
           std::abs(point.cost - point.full_gain - known.cost) <= agreement * unit;
  });
  if (met == optima_.end()) return std::nullopt;
  return static_cast<std::size_t>(met - optima_.begin());
}

}  // namespace fourpost
