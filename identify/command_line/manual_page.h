#pragma once

#include <string>
#include <vector>

#include "identify/command_line/command_table.h"

namespace fourpost {

/// The page that man(1) shows, in roff.
std::string ManualPage(const std::vector<CommandRow>& commands);

}  // namespace fourpost
