#pragma once

#include <string>
#include <vector>

#include "identify/residuals/history_misfit.h"

namespace fourpost {

/// Normalised mean square errors of time histories, and gain and delay that would make them least, as a table.
std::string HistoryTable(const std::vector<HistoryMisfit>& misfits);

/// Misfits beside their yardsticks; empty without any.
std::string YardstickTable(const std::vector<HistoryMisfit>& misfits);

}  // namespace fourpost
