#pragma once

#include <span>

namespace fourpost {

/// Standard deviation of the white noise in a signal that leaves a part of its band empty [its unit]: by the quarter of
/// all frequencies in which Welch's spectrum is lowest, if that is flat there: both halves of it within a factor of two.
/// 0 where it is not, and of less than 64 samples.
double NoiseFloor(std::span<const double> signal);

}  // namespace fourpost
