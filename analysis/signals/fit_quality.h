#pragma once

#include <span>

namespace fourpost {

/// Normalised mean square error of a model over N samples [%], thesis eqs. 3.9 and 4.28:
///   100 / (N var(measured)) sum (measured - modelled)^2,  var with 1/N;
/// 0 is a perfect model, 100 one that predicts the mean only. Infinite or NaN for a measured signal that is constant.
/// Throws std::invalid_argument unless both have the same length, one sample at least.
double NormalisedMse_percent(std::span<const double> measured, std::span<const double> modelled);

/// Variance accounted for [%]: 100 (1 - var(measured - modelled) / var(measured)). That of the normalised mean square
/// error, but blind to a constant offset. The same errors.
double VarianceAccountedFor_percent(std::span<const double> measured, std::span<const double> modelled);

}  // namespace fourpost
