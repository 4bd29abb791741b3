#pragma once

#include <filesystem>
#include <string>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Of a file that is not there: ", did you mean 'car/stepped_sine.csv'?" to end a message with, the file or folder
/// beside it whose name is nearest; empty when none is near.
std::string DidYouMeanFile(const std::filesystem::path& missing);

/// Whether a file is there. Where not, adds an error at the line of the file that names it.
bool RequireFile(const std::filesystem::path& file, const std::string& named_by, int line, Diagnostics& diagnostics);

}  // namespace fourpost
