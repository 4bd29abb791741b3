#pragma once

namespace fourpost {

/// From now on the first Ctrl-C (or SIGTERM) only asks to stop; a second one ends the program at once.
void CatchInterrupts();

/// Whether the user asked to stop.
bool Interrupted();

}  // namespace fourpost
