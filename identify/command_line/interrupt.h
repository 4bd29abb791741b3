#pragma once

namespace fourpost {

/// From now on the first Ctrl-C (or SIGTERM) only asks to stop, and says so; another one, two seconds
/// later or more, ends the program at once.
void CatchInterrupts();

/// Whether the user asked to stop.
bool Interrupted();

}  // namespace fourpost
