#pragma once

#include <CLI/CLI.hpp>

#include "identify/command_line/commands.h"

namespace fourpost {

/// Adds the options of `fourpost batch`; both must live until it has been parsed.
void AddOptions(CLI::App& subcommand, BatchCommand& command);

}  // namespace fourpost
