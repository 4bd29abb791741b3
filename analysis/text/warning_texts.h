#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// "file:line: message" of each warning, the file without its folder: for results, which are read elsewhere.
std::vector<std::string> WarningTexts(const Diagnostics& diagnostics);

}  // namespace fourpost
