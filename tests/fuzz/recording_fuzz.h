#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "analysis/files/recording/recording_file.h"

namespace fourpost {

/// Gives bytes to the reader of one format: they are refused by a RecordingFault, or every channel holds as many
/// samples as its header says, no more than the bytes explain, and the recording is a table that can be summarised.
void FuzzRecording(const std::string& bytes, const std::string& format,
                   std::unique_ptr<RecordingFile> (*open)(const std::filesystem::path& file));

}  // namespace fourpost
