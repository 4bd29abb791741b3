#pragma once

#include <vector>

namespace fourpost {

/// A signal less its mean; of none nothing.
std::vector<double> WithoutOffset(std::vector<double> signal);

/// A signal less its least-squares straight line.
std::vector<double> WithoutTrend(std::vector<double> signal);

}  // namespace fourpost
