#pragma once

#include <string>
#include <vector>

#include "identify/misfit.h"

namespace fourpost {

/// Normalised mean square errors of time histories, and gain and delay that would make them least, as a table.
std::string HistoryTable(const std::vector<HistoryMisfit>& misfits);

/// RemarksOn() these, a line each.
std::string HistoryRemarks(const std::vector<HistoryMisfit>& misfits, double sample_s);

}  // namespace fourpost
