#pragma once

#include <string>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Reports a recording through a low-pass filter that has fewer than four samples a period of the cut-off frequency. A
/// filter of fourth order leaves a tenth at 1.8 times its cut-off, so that with four next to nothing is aliased from
/// beyond half the sampling rate, and the filter is undone up to a fourth above its cut-off. False where it is too
/// slow.
bool CheckFilterRate(const std::string& recording, double rate_Hz, double cutoff_Hz, Place place,
                     Diagnostics& diagnostics);

}  // namespace fourpost
