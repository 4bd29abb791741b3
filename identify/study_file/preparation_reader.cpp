#include "identify/study_file/preparation_reader.h"

#include "identify/study_file/findings.h"

namespace fourpost {
namespace {

/// A list of files, or of {file, delay}.
std::vector<OtherFile> OtherFiles(const StrictMap& entry, const std::string& entry_name) {
  std::vector<OtherFile> others;
  const YAML::Node list = entry.Get("with");
  const std::string where = "'with' of " + entry_name;
  if (!list.IsSequence() || list.size() == 0) {
    entry.Fault(list, kHistoryWith, {where});
    return others;
  }
  for (const YAML::Node& one : list) {
    OtherFile& other = others.emplace_back();
    if (one.IsScalar()) {
      other.path = entry.Resolve(one.Scalar());
      continue;
    }
    const StrictMap map(one, where, {"file", "delay"}, entry.file(), entry.diagnostics());
    map.Require("file");
    if (const auto file = map.Text("file")) other.path = entry.Resolve(*file);
    other.delay_s = map.Quantity("delay", kTime, -1e9).value_or(0);
  }
  return others;
}

}  // namespace

TimePreparation ReadTimePreparation(const StrictMap& map, const std::string& where) {
  TimePreparation preparation{.rate_Hz = map.Quantity("resample", kFrequency, 1e-6),
                              .bridge_s = map.Quantity("bridge", kTime, 0).value_or(0)};
  if (map.Has("with")) preparation.others = OtherFiles(map, where);
  return preparation;
}

RecordingWindow ReadWindow(const StrictMap& map, const std::string& where, const Finding& empty) {
  // Clocks may begin before zero.
  constexpr double kEarliest_s = -1e9;
  const RecordingWindow window = {.start_s = map.Quantity("start", kTime, kEarliest_s),
                                  .end_s = map.Quantity("end", kTime, kEarliest_s)};
  if (window.start_s && window.end_s && !(*window.start_s < *window.end_s)) map.Fault(map.Get("end"), empty, {where});
  return window;
}

}  // namespace fourpost
