#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "analysis/files/recording/recording_file.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Whether the content of a file is of one of the formats that OpenRecording() reads, whatever its name is; not text
/// tables and MAT files.
bool IsRecordingFile(const std::filesystem::path& file);

/// Opens RPC III, UFF, TDMS, MDF, LVM and HDF5, by the file's content. What is not read of it becomes a warning, what
/// is wrong with it an error; null then.
std::shared_ptr<const RecordingFile> OpenRecording(const std::filesystem::path& file, Diagnostics& diagnostics);

/// First bytes of a file; fewer of a shorter one, none of what is no file.
std::string FileHead(const std::filesystem::path& file, std::size_t count = 1024);

}  // namespace fourpost
