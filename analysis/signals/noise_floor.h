#pragma once

#include <span>

namespace fourpost {

/// Standard deviation of the white noise in a signal that leaves a part of its band empty [its unit]: by Welch's
/// spectrum of the upper half of all frequencies, or of the quarter in which it is lowest, if it is flat there: both
/// halves of it within a factor of two. 0 where it is not, and of less than 64 samples.
double NoiseFloor(std::span<const double> signal);

}  // namespace fourpost
