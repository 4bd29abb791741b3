#pragma once

#include <string>
#include <vector>

#include "identify/misfit.h"

namespace fourpost {

/// Normalised mean square errors of time histories, and gain and delay that would make them least, as a table.
std::string HistoryTable(const std::vector<HistoryMisfit>& misfits);

/// Channels whose error nearly goes with another sign, or with a delay of more than `sample_s`. A line each.
std::string HistoryRemarks(const std::vector<HistoryMisfit>& misfits, double sample_s);

}  // namespace fourpost
