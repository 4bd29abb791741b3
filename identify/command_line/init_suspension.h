#pragma once

#include "identify/command_line/commands.h"

namespace fourpost {

/// `fourpost init DIR --suspension front=KIND,rear=KIND`: writes a vehicle of hard points into the folder, which may
/// have other files. Throws FaultyInput and OutputError.
int RunInitSuspension(const InitCommand& command);

}  // namespace fourpost
