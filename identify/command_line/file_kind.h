#pragma once

#include <filesystem>
#include <string>

namespace fourpost {

// By the file's ending, before it is read. Throw FaultyInput, telling what the file is and what is wanted, for a folder
// and for a file that is known to be of another kind.

void RequireVehicleFile(const std::filesystem::path& file);
void RequireStudyFile(const std::filesystem::path& file);
void RequireTable(const std::filesystem::path& file);
/// What to do about a file that is no recording, such as "is a study; ..."; empty for one that may be.
std::string NoRecording(const std::filesystem::path& file);
/// Whether it is a study; else it is a vehicle file.
bool IsStudyNotVehicle(const std::filesystem::path& file);

}  // namespace fourpost
