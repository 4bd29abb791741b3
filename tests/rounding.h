#pragma once

#include <limits>

namespace fourpost {

/// Distance of 1 to the next double: twice what rounding of a result takes at the most, relative to it.
inline constexpr double kUlp = std::numeric_limits<double>::epsilon();
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace fourpost
