#pragma once

#include <string>
#include <vector>

#include "vehicles/requests/history_channel.h"

namespace fourpost {

/// A time history as an SVG document: each channel as a whole, by the least and the greatest value of each of several
/// hundred slices, and the busiest second, the same for all; two channels side by side. `note`: a line below the title.
/// Throws std::invalid_argument without a channel, and for channels of fewer than two samples.
std::string HistorySvg(const std::string& title, const std::string& note, double start_s, double rate_Hz,
                       const std::vector<HistoryChannel>& channels);

}  // namespace fourpost
