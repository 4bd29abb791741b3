#include "identify/run/result_kind.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <nlohmann/json.hpp>

#include "analysis/files/output_folder.h"
#include "identify/run/findings.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

/// Keys that a command's results have, and none of those before it.
struct Mark {
  ResultKind kind;
  std::array<std::string_view, 2> keys;
};

constexpr std::array<Mark, 10> kMarks = {{{ResultKind::kFit, {"termination", "parameters"}},
                                          {ResultKind::kPrediction, {"was_fitted", "channels"}},
                                          {ResultKind::kResponse, {"direction", "modes"}},
                                          {ResultKind::kModes, {"parameters", "modes"}},
                                          {ResultKind::kKinematics, {"parameters", "axles"}},
                                          {ResultKind::kResponse, {"recordings", "channels"}},
                                          {ResultKind::kRide, {"parameters", "rides"}},
                                          {ResultKind::kChoice, {"lattice", "present"}},
                                          {ResultKind::kPlan, {"planned_runs", "planned_parameters"}},
                                          {ResultKind::kSimulation, {"motion", "samples"}}}};

constexpr std::array<std::string_view, 9> kCommands = {"fit",        "predict", "modes", "response", "ride",
                                                       "kinematics", "choose",  "plan",  "simulate"};

std::optional<ResultKind> KindOf(const nlohmann::json& result) {
  for (const Mark& mark : kMarks)
    if (std::all_of(mark.keys.begin(), mark.keys.end(), [&](std::string_view key) { return result.contains(key); }))
      return mark.kind;
  return std::nullopt;
}

std::optional<ResultKind> KindOf(const std::filesystem::path& folder) {
  std::error_code failure;
  if (std::filesystem::exists(folder / "archive.sqlite", failure)) return ResultKind::kFit;
  const nlohmann::json result = ReadResultFile(folder / "result.json");
  return result.is_object() ? KindOf(result) : std::nullopt;
}

}  // namespace

void RequireNoOtherResult(const std::filesystem::path& folder, ResultKind kind) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(folder / "result.json", failure)) return;
  const std::optional<ResultKind> there = KindOf(folder);
  if (there == kind) return;
  if (!there) throw OutputError(kFolderOfForeignResult, {folder.string()});
  throw OutputError(kFolderOfOtherResult, {folder.string()},
                    {std::string(kCommands[static_cast<std::size_t>(*there)])});
}

}  // namespace fourpost
