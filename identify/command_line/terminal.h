#pragma once

#include <cstddef>

namespace fourpost {

/// Whether this descriptor is a terminal that can clear a line and show colours.
bool IsTerminal(int descriptor);

/// Of a terminal now, since users change it; COLUMNS goes before it. 80 where neither is known.
std::size_t TerminalColumns(int descriptor);

/// A terminal of a user who does not refuse colours by NO_COLOR.
bool TakesColours(int descriptor);

}  // namespace fourpost
