#pragma once

#include <cstddef>
#include <span>

namespace fourpost {

/// A number of the vehicle: a constant, or a factor times one of the vehicle's parameters.
struct Scalar {
  double value = 0;
  int parameter = -1;
  double factor = 1;

  /// The number for these parameter values (SI, in the order of Vehicle::parameters).
  double At(std::span<const double> parameters) const {
    return parameter < 0 ? value : factor * parameters[static_cast<std::size_t>(parameter)];
  }

  /// Zero whatever the parameters are.
  bool IsZero() const { return parameter < 0 ? value == 0 : factor == 0; }
};

}  // namespace fourpost
