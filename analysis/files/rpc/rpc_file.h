#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "analysis/files/recording/recording_file.h"

namespace fourpost {

/// Opens a time history of RPC III (.rsp, .drv, .tim): numbers of both byte orders or in ASCII, SHORT_INTEGER, which
/// SCALE.CHAN_n multiplies, or FLOATING_POINT. BINARY is BINARY_IEEE_LITTLE_END ("RPC III File Formats", MTS, table
/// 6-1). Half frames before and behind the data hold none and are left out, as is what fills up the last group. Throws
/// RecordingFault.
std::unique_ptr<RecordingFile> OpenRpc(const std::filesystem::path& file);

}  // namespace fourpost
