#pragma once

#include <optional>

#include <Eigen/Core>

#include "vehicles/posts/recorded_posts.h"

namespace fourpost {

/// Between samples posts follow a spline, which as many samples a period hold to a few per cent.
inline constexpr double kLeastSamplesAPeriod = 6;

/// The frequency [Hz] up to which a post moves, of a height that is sampled less often; else nothing. `filter`: of the
/// rig.
std::optional<double> SampledTooSlowly(const Eigen::VectorXd& height, double rate_Hz,
                                       const std::optional<LowPassDesign>& filter);

}  // namespace fourpost
