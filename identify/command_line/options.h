#pragma once

#include <CLI/CLI.hpp>

#include "identify/command_line/commands.h"

namespace fourpost {

// Add the options of a subcommand; both must live until it has been parsed.

/// Of a vehicle that is shown: modes, frequencies, amplitudes and channels.
void AddShownSweep(CLI::App& subcommand, SweepText& sweep);
void AddOptions(CLI::App& subcommand, InitCommand& command);
void AddOptions(CLI::App& subcommand, ResponseCommand& command);
void AddOptions(CLI::App& subcommand, ModesCommand& command);
void AddOptions(CLI::App& subcommand, KinematicsCommand& command);
void AddOptions(CLI::App& subcommand, SettleCommand& command);
void AddOptions(CLI::App& subcommand, PredictCommand& command);
void AddOptions(CLI::App& subcommand, PlanCommand& command);

}  // namespace fourpost
