#pragma once

#include <span>
#include <vector>

#include "analysis/signals/low_pass.h"

namespace fourpost {

/// What a causal low-pass filter was given, from what it gave: the spectrum of the record divided by the filter's
/// response, untouched up to `passes` cycles per sample, faded out by a half cosine up to `stops`, where noise would be
/// amplified by what the filter took away. Exact for signals within the pass band that rest before the record; at the
/// end, what the filter had not yet let through is not known: the last samples, as many as the filter's delay and some
/// more, are wrong.
/// Throws std::invalid_argument for an empty record and unless 0 < passes < stops <= 1/2.
std::vector<double> Unfiltered(std::span<const double> filtered, const LowPass& filter, double passes, double stops);

/// The same up to one and a half times the filter's cutoff (cycles per sample), faded out up to two and a half times,
/// where a filter of fourth order has left a fortieth; but for slow recordings up to 0.4 cycles per sample, short of
/// the filter's zeros at half a cycle.
std::vector<double> Unfiltered(std::span<const double> filtered, const LowPass& filter, double cutoff);

}  // namespace fourpost
