#pragma once

#include <vector>

namespace fourpost {

/// An axis of a chart: its limits, and the values that get a grid line and a label.
struct ChartAxis {
  double lower = 0;
  double upper = 1;
  bool logarithmic = false;
  std::vector<double> ticks;

  /// Place of a value along the axis: 0 at `lower`, 1 at `upper`. Not finite where a logarithmic axis has no place.
  double Fraction(double value) const;

  /// Throws std::invalid_argument unless the limits are finite and increase, and are positive on a logarithmic axis.
  void Validate() const;
};

/// A linear axis over at least lower..upper, from tick to tick: multiples of the smallest of 1, 2, 5 times a power of
/// ten that makes at most `intervals` of them. Throws std::invalid_argument for limits that do not increase and fewer
/// than two intervals, with which no range about zero could end on ticks.
ChartAxis LinearAxis(double lower, double upper, int intervals);

/// A logarithmic axis over lower..upper with ticks at 1, 2, 5 in each decade, and at the outermost of the other digits
/// where there is room: 0.5 1 2 5 10 20 30. Ticks as of a linear axis where these are fewer than two. Throws
/// std::invalid_argument for limits that do not increase or are not positive.
ChartAxis LogAxis(double lower, double upper);

}  // namespace fourpost
