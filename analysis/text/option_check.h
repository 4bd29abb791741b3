#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace fourpost {

/// For options' Validate(): throws std::invalid_argument "field = value, must be bound" unless `good`.
/// Write `good` so that it is false for NaN.
template <typename Value>
void RequireOption(bool good, std::string_view field, const Value& value, std::string_view bound) {
  if (good) return;
  std::ostringstream message;
  message << field << " = " << value << ", must be " << bound;
  throw std::invalid_argument(message.str());
}

inline void RequirePositive(std::string_view field, double value) {
  RequireOption(value > 0 && std::isfinite(value), field, value, "positive and finite");
}

}  // namespace fourpost
