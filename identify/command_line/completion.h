#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "identify/command_line/command_table.h"

namespace fourpost {

inline constexpr std::array<std::string_view, 3> kShells = {"bash", "zsh", "fish"};

/// What teaches one of kShells to complete commands, their options, the words these take, and files for all else.
std::string CompletionScript(const std::vector<CommandRow>& commands, std::string_view shell);

}  // namespace fourpost
