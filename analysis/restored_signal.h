#pragma once

#include <span>
#include <vector>

#include "analysis/low_pass.h"

namespace fourpost {

/// Samples at either end of a restored signal that the ends of the recording disturb.
inline constexpr int kRestoringReach = 12;

/// The signal that a low-pass of even order made `filtered` of, without delay. The poles of a Butterworth filter by the
/// bilinear transform are undone exactly; its `order` zeros at half the sampling rate, cos^order(w h / 2) without their
/// delay of order/2 samples, by the first four terms of
///   cos^-order(w h / 2) = (1 - s)^(-order/2) = 1 + (order/2) s + ...,  s = sin^2(w h / 2) = (2 - z - 1/z) / 4,
/// after which a share s^4 times 5 (order 4) is missing: 1e-5 at 30 Hz sampled at 500 Hz, all at half the sampling
/// rate. Noise that the filter has not passed, such as that of rounding, is amplified. Before its start the recording
/// is taken to have rested at its first sample. Throws std::invalid_argument for a filter of odd order.
std::vector<double> RestoredSignal(const LowPass& filter, std::span<const double> filtered);

}  // namespace fourpost
