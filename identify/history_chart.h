#pragma once

#include <string>
#include <vector>

#include "identify/history_channel.h"

namespace fourpost {

/// A time history as an SVG document: of each channel all of it, by the least and the greatest value of each of several
/// hundred slices, and, of a history of more than two seconds, the second in which most happens, the same for all. Two
/// channels side by side where there are more than three. Throws std::invalid_argument without a channel, and for
/// channels of fewer than two samples.
std::string HistorySvg(const std::string& title, double start_s, double rate_Hz,
                       const std::vector<HistoryChannel>& channels);

}  // namespace fourpost
