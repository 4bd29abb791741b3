#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "analysis/files/recording/recording_file.h"

namespace fourpost {

/// Opens a LabVIEW measurement file (.lvm, text): no column of times, one, or one a channel; several parts with the
/// same channels follow each other. Times are X0 and Delta_X of the header where the column of times agrees with them
/// or is not there. Empty fields are NaN; comments are left out. A part with fewer samples
/// than its header states is a fault. Throws RecordingFault.
std::unique_ptr<RecordingFile> OpenLvm(const std::filesystem::path& file);

bool IsLvm(std::string_view head);

}  // namespace fourpost
