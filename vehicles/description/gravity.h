#pragma once

namespace fourpost {

/// Standard acceleration of free fall [m/s^2] (3rd CGPM, 1901).
inline constexpr double kGravity = 9.80665;

}  // namespace fourpost
