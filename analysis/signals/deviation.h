#pragma once

#include <span>

namespace fourpost {

/// NaN of none.
double Mean(std::span<const double> signal);

/// Standard deviation about the mean, with 1/N; 0 of none.
double DeviationOf(std::span<const double> signal);

}  // namespace fourpost
