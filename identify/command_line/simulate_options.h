#pragma once

#include <CLI/CLI.hpp>

#include "identify/command_line/commands.h"

namespace fourpost {

/// Adds the subcommand `simulate`; parsing fills `command`, which must live as long as the subcommand.
CLI::App* AddSimulate(CLI::App& app, SimulateCommand& command);

}  // namespace fourpost
