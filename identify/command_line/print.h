#pragma once

#include <string>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// With '?' for characters that control a terminal, which names in a file may hold; line breaks and tabs stay.
std::string WithoutControls(std::string text);

/// Tells findings about the user's files on stderr; nothing when there are none.
void Tell(const Diagnostics& diagnostics);

/// Writes a result to stdout. Throws OutputError when it does not get there, as on a full disk.
void Print(const std::string& text);

}  // namespace fourpost
