#pragma once

namespace fourpost {

// Residuals over noise and stated model error, of a whole fit or of a channel.

/// Below it the study states more noise and model error than there is.
inline constexpr double kSmallMisfit = 0.3;
/// Up to it noise and stated model error explain the residuals.
inline constexpr double kExplainedMisfit = 1.1;
/// Above it the model lacks something.
inline constexpr double kLargeMisfit = 1.5;
/// Far above it: what the model lacks is several times what is stated.
inline constexpr double kFarMisfit = 3;

}  // namespace fourpost
