#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/text/units.h"

namespace fourpost {

/// A number by which settings are compared.
struct Metric {
  std::string name;
  Dimension dimension;
  /// Unit in which it is shown: "mm", "%".
  std::string unit;
  /// An SI unit that no dimension has, "m/s^1.75"; empty: that of the dimension.
  std::string odd_unit = {};
  /// Whether less is better. Only such a metric can be an objective.
  bool is_cost = true;
  /// What it measures, in a few words.
  std::string words;

  std::string UnitInSi() const;
};

/// Metrics of a car with these parameter values (SI, order of Vehicle::parameters) on each road: roads x metrics, SI.
/// Called from several threads at once. Throws std::runtime_error for a car without an answer, such as an unstable one.
using MetricsOf = std::function<Eigen::MatrixXd(std::span<const double> parameters)>;

/// A metric to minimise, together with others by their weights.
struct Objective {
  std::size_t metric = 0;
  /// They add up to 1.
  double weight = 1;
};

/// What a metric may be at most or must be at least, on every road; SI.
struct MetricLimit {
  std::size_t metric = 0;
  std::optional<double> most;
  std::optional<double> least;
  int line = 0;

  /// How far a value is inside, in the metric's unit; negative: beyond the limit; NaN of NaN.
  double MarginOf(double value) const;
};

/// Of roads x metrics: an objective's value over all roads, the root of the mean square by the roads' weights, as
/// exposures add up (ISO 2631-1, 8.2); `weights` add up to 1.
double OverRoads(const Eigen::MatrixXd& metrics, std::size_t metric, std::span<const double> weights);

/// Of the road on which it is least; NaN where it is not known on one.
double LeastMargin(const Eigen::MatrixXd& metrics, const MetricLimit& limit);

}  // namespace fourpost
