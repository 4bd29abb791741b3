#pragma once

#include <string>
#include <vector>

#include "analysis/files/output_folder.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost {

/// With '?' for characters that control a terminal, which names in a file may hold; line breaks and tabs stay.
std::string WithoutControls(std::string text);

/// Prints findings on stderr, in colours where that takes them; nothing when there are none.
void Tell(const Diagnostics& diagnostics);
/// The same of one.
void Tell(const Finding& finding, Place place = {}, const std::vector<std::string>& words = {});
/// One that is formatted already.
void Tell(const OutputError& error);
void Tell(const SimulationError& error);

/// Writes a text for readers to stdout, wrapped on a terminal. Throws OutputError as Print() does.
void PrintText(const std::string& text);

/// Writes a result to stdout as it is. Throws OutputError when it does not get there, as on a full disk.
void Print(const std::string& text);

}  // namespace fourpost
