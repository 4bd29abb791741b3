#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Frequencies as a user writes them, rising [Hz]:
///   "0.5Hz:30Hz:40"     forty from 0.5 to 30 Hz, each the same ratio above the one before;
///   "0.5Hz:30Hz:0.5Hz"  every 0.5 Hz, from the first as far as the last lets them;
///   "1Hz,2Hz,5Hz"       these.
/// Nothing after an error about `option`: a part that is no frequency above zero with its unit Hz, a range that does
/// not rise, fewer than two or more than 10,000 in a range, one that stands twice in a list.
std::optional<std::vector<double>> ParseFrequencies(std::string_view text, const std::string& option,
                                                    Diagnostics& diagnostics);

}  // namespace fourpost
