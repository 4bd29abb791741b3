#include "analysis/signals/spline_through.h"

#include <vector>

namespace fourpost {

UniformSpline SplineThrough(std::span<const double> samples, double start, double step) {
  const std::vector<double> values(samples.begin(), samples.end());
  const std::vector<double> backwards(samples.rbegin(), samples.rend());
  return {start, step, values, SlopeAtStart(values, step), -SlopeAtStart(backwards, step)};
}

}  // namespace fourpost
