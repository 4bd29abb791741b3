#pragma once

#include <vector>

#include "identify/bench_data.h"
#include "identify/residual_block.h"

namespace fourpost {

/// Samples of a recording from one residual to the next: what a rig's filter has passed needs no more than four samples
/// per period of its cutoff; every one without a filter.
std::size_t ResidualStride(const BenchRecording& recording);

/// Of the independent numbers in a recording's force: two per period of the filter's cutoff, all samples without one.
double IndependentSamples(const BenchRecording& recording);

/// (modelled - measured) / (model_error sd(measured)) sqrt(independent / residuals) of every recording, so that each
/// recording counts by its normalised mean square error and by its independent samples. The vehicle must outlive the
/// block. Infeasible where a chamber of a hydraulic damper closes.
ResidualBlock BenchResiduals(const Vehicle& vehicle, const BenchData& data, double model_error);

}  // namespace fourpost
