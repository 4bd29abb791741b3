#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/measured_response/measured_response.h"

namespace fourpost {

/// Throws FaultyInput, with the faults that there are already, where a file is of another kind.
void RequireRecordings(const ResponseRequest& request, Diagnostics& findings);

/// What `fourpost frf` makes of time histories. Throws FaultyInput with all faults of the files; adds warnings, also of
/// what was perhaps forgotten to state, to `findings`.
MeasuredResponses MeasureFiles(const ResponseRequest& request, Diagnostics& findings);

/// Its frf.json.
std::string MeasuredFilesJson(const MeasuredResponses& measured, const Diagnostics& findings);

/// The folder of `fourpost frf -o`. Throws FaultyInput where it holds an input, OutputError where it cannot be written.
void RequireMeasuredFolder(const ResponseRequest& request, const std::filesystem::path& folder);
void WriteMeasured(const std::filesystem::path& folder, const std::string& json, const MeasuredResponses& measured);

}  // namespace fourpost
