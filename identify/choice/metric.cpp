#include "identify/choice/metric.h"

#include <algorithm>
#include <cmath>

namespace fourpost {

std::string Metric::UnitInSi() const { return odd_unit.empty() ? SiUnit(dimension) : odd_unit; }

double MetricLimit::MarginOf(double value) const {
  if (std::isnan(value)) return value;
  double margin = HUGE_VAL;
  if (most) margin = std::min(margin, *most - value);
  if (least) margin = std::min(margin, value - *least);
  return margin;
}

double OverRoads(const Eigen::MatrixXd& metrics, std::size_t metric, std::span<const double> weights) {
  double square = 0;
  for (std::size_t road = 0; road < weights.size(); ++road) {
    const double value = metrics(static_cast<Eigen::Index>(road), static_cast<Eigen::Index>(metric));
    square += weights[road] * value * value;
  }
  return std::sqrt(square);
}

double LeastMargin(const Eigen::MatrixXd& metrics, const MetricLimit& limit) {
  double margin = HUGE_VAL;
  for (Eigen::Index road = 0; road < metrics.rows(); ++road) {
    const double here = limit.MarginOf(metrics(road, static_cast<Eigen::Index>(limit.metric)));
    if (std::isnan(here)) return here;
    margin = std::min(margin, here);
  }
  return margin;
}

}  // namespace fourpost
