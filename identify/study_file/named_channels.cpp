#include "identify/study_file/named_channels.h"

#include <algorithm>
#include <set>

#include "analysis/files/recording_layout.h"

namespace fourpost {
namespace {

constexpr const char* kOthers = "others";
constexpr const char* kByName = "by name";

}  // namespace

bool IsOthersByName(const std::string& name, const YAML::Node& value) {
  return name == kOthers && value.IsScalar() && value.Scalar() == kByName;
}

bool TakesOthersByName(const YAML::Node& channels) {
  if (!channels.IsDefined()) return true;
  return channels.IsMap() && channels[kOthers].IsDefined() && IsOthersByName(kOthers, channels[kOthers]);
}

std::vector<std::string> ChannelNames(const RecordedTable& table) {
  if (!IsSteppedSine(table)) return table.names();
  const std::size_t column = *table.FindColumn("channel");
  std::vector<std::string> names;
  std::set<std::string> known;
  for (std::size_t row = 0; row < table.rows(column); ++row)
    if (std::string name = table.Text(row, column); known.insert(name).second) names.push_back(std::move(name));
  return names;
}

void AddByName(std::span<const std::string> names, std::span<const std::string> recorded, int line,
               std::vector<std::pair<std::string, ChannelSource>>& sources) {
  const std::size_t stated = sources.size();
  for (const std::string& name : names) {
    const auto is_it = [&](const auto& source) { return source.first == name; };
    const auto end = sources.begin() + static_cast<std::ptrdiff_t>(stated);
    if (std::any_of(sources.begin(), end, is_it)) continue;
    if (std::find(recorded.begin(), recorded.end(), name) == recorded.end()) continue;
    sources.emplace_back(name, ChannelSource{.channels = {SourceChannel(name)}, .line = line});
  }
}

}  // namespace fourpost
