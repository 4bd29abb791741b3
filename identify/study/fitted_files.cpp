#include "identify/study/fitted_files.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "analysis/files/sha256.h"
#include "analysis/files/text_file.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

std::optional<std::string> DigestOf(const std::filesystem::path& file) {
  if (WhyNoFile(file)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  Sha256 digest;
  // A recording may be larger than memory.
  std::string piece(std::size_t{1} << 20, '\0');
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0)
    digest.AddBytes(std::string_view(piece).substr(0, static_cast<std::size_t>(stream.gcount())));
  return digest.Hex();
}

/// Each file once.
std::vector<FileDigest> DigestsOf(const std::vector<std::filesystem::path>& files) {
  std::set<std::filesystem::path> known;
  std::vector<FileDigest> digests;
  for (const std::filesystem::path& file : files) {
    if (!known.insert(file).second) continue;
    if (const std::optional<std::string> digest = DigestOf(file))
      digests.push_back({.name = file.filename().string(), .sha256 = *digest});
  }
  return digests;
}

std::vector<std::filesystem::path> FilesOf(const Study& study, ExperimentFile::Use use) {
  std::vector<std::filesystem::path> files;
  for (const Experiment& experiment : study.experiments)
    for (const ExperimentFile& file : experiment.Files())
      if (file.use == use) files.push_back(file.path);
  return files;
}

}  // namespace

std::vector<FileDigest> FittedFiles(const Study& study) {
  return DigestsOf(FilesOf(study, ExperimentFile::Use::kFitted));
}

std::vector<FileDigest> ValidationFiles(const Study& study) {
  std::vector<std::filesystem::path> files = FilesOf(study, ExperimentFile::Use::kValidation);
  for (const Experiment& experiment : study.experiments)
    for (const LeftOutRecording& out : experiment.left_out()) std::erase(files, out.file);
  return DigestsOf(files);
}

bool WasFitted(const std::filesystem::path& result, const std::filesystem::path& recording) {
  const nlohmann::json json = ReadResultFile(result);
  const std::optional<std::string> digest = DigestOf(recording);
  if (!json.is_object() || !json.contains("fitted_files") || !json["fitted_files"].is_array() || !digest) return false;
  return std::any_of(json["fitted_files"].begin(), json["fitted_files"].end(), [&](const nlohmann::json& entry) {
    return entry.is_object() && entry.value("sha256", nlohmann::json()) == *digest;
  });
}

}  // namespace fourpost
