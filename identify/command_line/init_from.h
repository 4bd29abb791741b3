#pragma once

#include "identify/command_line/commands.h"

namespace fourpost {

/// `fourpost init DIR --from FILES --vehicle V`: writes the draft of a study into the folder, which may have other
/// files. Throws FaultyInput and OutputError.
int RunInitFrom(const InitCommand& command);

}  // namespace fourpost
