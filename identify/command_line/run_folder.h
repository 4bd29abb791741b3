#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/run_contents.h"

namespace fourpost {

/// Folders that `fourpost fit` wrote, by name, and what they hold. Throws FaultyInput with the faults of all: no
/// folder, one that stands twice, no result.json, one that is not that of a fit, files that cannot be read.
std::vector<std::pair<std::string, RunContents>> ReadRuns(const std::vector<std::filesystem::path>& folders);

/// Throws FaultyInput as ReadRuns() does for a folder without the result of a fit.
void RequireFitResult(const std::filesystem::path& folder);

/// A finding about a file of a run, at its path; as it is where it has one.
Diagnostic InFolder(const std::filesystem::path& folder, Diagnostic finding);

/// Files of a run's folder that an output must not replace.
std::vector<std::filesystem::path> RunFiles(const std::filesystem::path& folder);

}  // namespace fourpost
