#include "identify/experiments/run_folder.h"

#include <filesystem>
#include <set>

#include "identify/study_file/result_reader.h"

namespace fourpost {

const std::string* RunFolder::Find(const std::string& file) const {
  const auto found = contents.files.find(file);
  return found == contents.files.end() ? nullptr : &found->second;
}

std::string RunFolder::FileNamed(const std::string& file) const {
  return (std::filesystem::path(folder) / file).string();
}

std::vector<std::string> FittedRecordings(const nlohmann::json& result) {
  std::set<std::string> names;
  for (const nlohmann::json& recording : ListAt(result, "recordings")) names.insert(TextAt(recording, "name"));
  for (const nlohmann::json& channel : ListAt(result, "channels")) names.insert(TextAt(channel, "recording"));
  names.erase("");
  return {names.begin(), names.end()};
}

}  // namespace fourpost
