#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "analysis/files/recording/recording_file.h"

namespace fourpost {

/// Opens an MDF file of version 3 or 4 with sorted records: integers and floats of any place and order of bytes,
/// linear, rational and tabular conversions, invalidation bits (NaN), data in one block, in lists, and packed (DZ),
/// transposed or not. Each channel group has its times. Channels of texts, arrays and other conversions are left out
/// with a remark. Throws RecordingFault.
std::unique_ptr<RecordingFile> OpenMdf(const std::filesystem::path& file);

bool IsMdf(std::string_view head);

}  // namespace fourpost
