#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identify/study/study.h"
#include "identify/study_file/left_out_recording.h"

namespace fourpost {

/// A recording as it was read.
struct FileDigest {
  /// Without its folder.
  std::string name;
  /// Of its bytes.
  std::string sha256;
};

/// Of a study those recordings that are there to be fitted, each file once; what cannot be read is left out.
std::vector<FileDigest> FittedFiles(const Study& study);
/// Likewise those that are kept for validation, but for those that its experiments left out.
std::vector<FileDigest> ValidationFiles(const Study& study);

/// Whether the fit that wrote this result.json has seen the recording, under whatever name: then what its model answers
/// is a fit error, not a prediction. False where that is not known, as of results of earlier versions.
bool WasFitted(const std::filesystem::path& result, const std::filesystem::path& recording);

}  // namespace fourpost
