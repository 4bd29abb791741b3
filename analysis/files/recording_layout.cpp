#include "analysis/files/recording_layout.h"

#include <algorithm>

#include "analysis/files/time_recording.h"

namespace fourpost {
namespace {

/// "Time" of "Time [s]", "Time (s)" and "Time / s".
std::string WithoutUnit(const std::string& name) { return name.substr(0, name.find_first_of(" [(/")); }

}  // namespace

bool IsSteppedSine(const RecordedTable& table) {
  return table.FindColumn("frequency_Hz") && table.FindColumn("channel");
}

bool IsTimeHistory(const RecordedTable& table) {
  const auto is_time = [](const std::string& name) {
    const std::vector<std::string>& usual = kTimeColumn.names;
    return std::find(usual.begin(), usual.end(), WithoutUnit(name)) != usual.end();
  };
  return !IsSteppedSine(table) && std::any_of(table.names().begin(), table.names().end(), is_time);
}

}  // namespace fourpost
