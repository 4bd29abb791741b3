#include <algorithm>

#include "analysis/files/json_text.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "identify/inspection/described_file.h"

namespace fourpost {
namespace {

std::string AllText(const std::vector<DescribedFile>& files) {
  std::string text;
  for (const DescribedFile& file : files) text += (text.empty() ? "" : "\n") + file.file + ": " + file.text;
  return text;
}

std::string AllJson(const std::vector<DescribedFile>& files) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DescribedFile& file : files) list.push_back(file.json);
  return JsonText(nlohmann::ordered_json{{"files", list}});
}

}  // namespace

int Run(const InfoCommand& command) {
  Diagnostics faults;
  std::vector<DescribedFile> files;
  for (const std::filesystem::path& file : command.files)
    if (std::optional<DescribedFile> described = DescribeFile(file, faults)) files.push_back(*std::move(described));
  if (!files.empty() && command.json) Print(AllJson(files));
  else if (!files.empty()) PrintText(AllText(files));
  if (faults.HasErrors()) throw FaultyInput(faults);
  Tell(faults);
  const auto is_refused = [](const DescribedFile& file) { return file.is_refused; };
  return std::any_of(files.begin(), files.end(), is_refused) ? kUnreadableInput : kGood;
}

}  // namespace fourpost
