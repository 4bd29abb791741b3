#pragma once

#include "identify/command_line/commands.h"

namespace fourpost {

/// `fourpost response` of a study: its vehicle, as the file has it, compared with its recordings.
int RespondToStudy(const ResponseCommand& command);

/// `fourpost response` of a vehicle file.
int RespondOfVehicle(const ResponseCommand& command);

}  // namespace fourpost
