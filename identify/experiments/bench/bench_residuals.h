#pragma once

#include <vector>

#include "identify/experiments/bench/bench_data.h"
#include "identify/residuals/residual_block.h"

namespace fourpost {

/// Samples of a recording from one residual to the next: two per period of the cutoff of the rig's filter, since
/// more hold no more information; every one without a filter.
std::size_t ResidualStride(const BenchRecording& recording);

/// (modelled - measured) / (model_error sd(measured)) of every recording, so that each counts by its normalised mean
/// square error. Infeasible where a chamber of a hydraulic damper closes.
ResidualBlock BenchResiduals(const Vehicle& vehicle, const BenchData& data, double model_error);

}  // namespace fourpost
