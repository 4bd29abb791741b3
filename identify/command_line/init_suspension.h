#pragma once

#include "identify/command_line/commands.h"

namespace fourpost {

/// `fourpost init DIR --suspension front=KIND,rear=KIND`: writes a vehicle of hard points into the folder, which may
/// have other files. Throws FaultyInput and OutputError.
int RunInitSuspension(const InitCommand& command);

/// `fourpost init DIR --chrono FILE`: the same of a vehicle of Project Chrono.
int RunInitChrono(const InitCommand& command);

}  // namespace fourpost
