#pragma once

#include <filesystem>

namespace fourpost {

/// The commands that write folders of results.
enum class ResultKind { kFit, kPrediction, kModes, kResponse, kRide, kKinematics, kChoice, kPlan, kSimulation };

/// Throws OutputError when the folder holds the result.json of another command, or one that names none. An
/// archive.sqlite is that of a fit, whatever its result.json has become.
void RequireNoOtherResult(const std::filesystem::path& folder, ResultKind kind);

}  // namespace fourpost
