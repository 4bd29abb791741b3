#pragma once

#include <span>
#include <vector>

#include "analysis/frequency_response/tone_track.h"

namespace fourpost {

// Frequencies for the response to a motion that is not periodic: 64, each the same ratio above the one before, over the
// band in which the motion has power. Empty where there is no such band.

/// Of a random motion: about its largest spectral density, as far as this is a hundred times that of its noise, below
/// it 3 % of the largest, where posts move most, above it 1e-5, and the record has 20 periods.
std::vector<double> MovedFrequencies(std::span<const double> motion, double rate_Hz);

/// Of a sweep: from above its lowest to below its highest frequency, next to which it cannot be separated from the
/// run-in and run-out, as far as the record has 60 periods. These are of tones that noise would not bring forth and
/// that follow each other, so that neither rest before and behind the sweep counts nor a hum.
std::vector<double> SweptFrequencies(std::span<const TonePoint> sweep, double rate_Hz, double duration_s);

/// Amplitude of a sweep as it passes a frequency: the median over the points within 5 % of it, or of the nearest.
double SweptAmplitude(std::span<const TonePoint> sweep, double cycles_per_sample);

}  // namespace fourpost
