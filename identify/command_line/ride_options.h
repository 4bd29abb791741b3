#pragma once

#include <CLI/CLI.hpp>

#include "identify/command_line/commands.h"

namespace fourpost {

/// Adds the options of a subcommand; `command` must live until it has been parsed.
void AddOptions(CLI::App& subcommand, RideCommand& command);

}  // namespace fourpost
