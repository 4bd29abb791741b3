#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "analysis/files/recording/recording_file.h"

namespace fourpost {

/// Opens a TDMS file of National Instruments, versions 4712 and 4713: segments in both byte orders, interleaved or not,
/// with linear and polynomial scalings applied. A channel's step and start are its properties wf_increment and
/// wf_start_offset; one of time stamps is in seconds after its first. Channels of texts and complex numbers, and those
/// of other scalings, are left out with a remark. Throws RecordingFault.
std::unique_ptr<RecordingFile> OpenTdms(const std::filesystem::path& file);

bool IsTdms(std::string_view head);

}  // namespace fourpost
