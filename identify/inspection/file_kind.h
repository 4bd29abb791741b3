#pragma once

#include <filesystem>

#include "analysis/text/diagnostics.h"

namespace fourpost {

// By the file's ending, before it is read. Throw FaultyInput, saying what the file is and what is needed, for a folder
// and for a file that is known to be of another kind.

void RequireVehicleFile(const std::filesystem::path& file);
void RequireStudyFile(const std::filesystem::path& file);
void RequireTable(const std::filesystem::path& file);
/// Reports a file that is no recording.
bool MayBeRecording(const std::filesystem::path& file, Diagnostics& faults);
bool IsStudy(const std::filesystem::path& file);
/// Whether it is a study; else it is a vehicle file.
bool IsStudyNotVehicle(const std::filesystem::path& file);

}  // namespace fourpost
