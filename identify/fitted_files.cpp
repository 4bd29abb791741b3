#include "identify/fitted_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include <nlohmann/json.hpp>

#include "analysis/sha256.h"

namespace fourpost {
namespace {

std::optional<std::string> DigestOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  Sha256 digest;
  digest.AddBytes(std::string(std::istreambuf_iterator<char>(stream), {}));
  return digest.Hex();
}

}  // namespace

std::vector<FittedFile> FittedFiles(const Study& study) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::filesystem::path& file) {
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  };
  for (const StudyRecording& recording : study.recordings) add(recording.file);
  for (const StudyHistory& history : study.histories)
    if (!history.is_validation) add(history.file);
  if (study.bench)
    for (const BenchStudy::Recording& recording : study.bench->recordings) add(recording.file);
  std::vector<FittedFile> fitted;
  for (const std::filesystem::path& file : files)
    if (const std::optional<std::string> digest = DigestOf(file))
      fitted.push_back({.name = file.filename().string(), .sha256 = *digest});
  return fitted;
}

bool WasFitted(const std::filesystem::path& result, const std::filesystem::path& recording) {
  std::ifstream file(result);
  const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  const std::optional<std::string> digest = DigestOf(recording);
  if (!json.is_object() || !json.contains("fitted_files") || !json["fitted_files"].is_array() || !digest) return false;
  return std::any_of(json["fitted_files"].begin(), json["fitted_files"].end(), [&](const nlohmann::json& entry) {
    return entry.is_object() && entry.value("sha256", nlohmann::json()) == *digest;
  });
}

}  // namespace fourpost
