#pragma once

#include <string>
#include <vector>

#include "identify/residuals/history_misfit.h"

namespace fourpost {

/// Normalised mean square errors of time histories, and gain and delay that would make them least, as a table.
std::string HistoryTable(const std::vector<HistoryMisfit>& misfits);

/// What explains a table, or where it stands already in the text `above`.
std::string OnceExplained(const std::string& explanation, const std::string& above);

/// Misfits beside their yardsticks; empty without any. What `above` explains is not explained again.
std::string YardstickTable(const std::vector<HistoryMisfit>& misfits, const std::string& above = "");

}  // namespace fourpost
