#include "identify/experiments/bench/bench_study.h"

#include <algorithm>
#include <utility>

#include "identify/experiments/bench/findings.h"
#include "identify/study_file/channel_source_reader.h"
#include "identify/study_file/control_reader.h"
#include "identify/study_file/findings.h"
#include "identify/study_file/preparation_reader.h"

namespace fourpost {
namespace {

class BenchReader {
 public:
  BenchReader(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  BenchStudy Read(const YAML::Node& node) {
    const StrictMap map(
        node, "'bench'",
        {"damper", "displacement", "force", "time", "rig_filter", "model_error", "recordings", "validation"}, file_,
        diagnostics_);
    study_.line = LineOf(node);
    study_.damper = map.Text("damper");
    if (const auto displacement = Channel(map, "displacement")) study_.displacement = *displacement;
    if (const auto force = Channel(map, "force")) study_.force = *force;
    study_.time = Channel(map, "time");
    if (map.Has("rig_filter")) ReadFilter(map.Get("rig_filter"));
    study_.model_error = map.Quantity("model_error", kDimensionless, 0).value_or(study_.model_error);
    if (study_.model_error == 0) map.FaultOf("model_error", kKeyNotPositive);
    if (const YAML::Node list = map.Require("recordings"); list.IsDefined())
      ReadRecordings(list, "'recordings'", study_.recordings);
    if (map.Has("validation")) ReadRecordings(map.Get("validation"), "'validation'", study_.validation);
    return study_;
  }

 private:
  std::optional<SourceChannel> Channel(const StrictMap& map, const char* key, const std::string& of = "") {
    if (!map.Has(key)) return std::nullopt;
    return ReadSourceChannel(map.Get(key), "'" + std::string(key) + "'" + of, ChannelKind::kHistory, file_,
                             diagnostics_);
  }

  void ReadFilter(const YAML::Node& node) {
    const StrictMap map(node, "'rig_filter'", {"order", "cutoff"}, file_, diagnostics_);
    RigFilter filter;
    filter.order = static_cast<int>(map.Integer("order", 1, 16).value_or(filter.order));
    map.Require("cutoff");
    filter.cutoff_Hz = map.Quantity("cutoff", kFrequency, 0).value_or(filter.cutoff_Hz);
    if (filter.cutoff_Hz == 0) map.FaultOf("cutoff", kKeyNotPositive);
    study_.rig_filter = filter;
  }

  /// Files, or mappings.
  void ReadRecordings(const YAML::Node& list, const std::string& where, std::vector<BenchStudy::Recording>& out) {
    if (!list.IsSequence() || list.size() == 0) {
      diagnostics_.Report(kBenchRecordingsEmpty, {file_, LineOf(list)}, {where});
      return;
    }
    for (const YAML::Node& entry : list) {
      BenchStudy::Recording recording = ReadRecording(entry);
      const auto same = [&](const BenchStudy::Recording& other) { return other.name == recording.name; };
      if (std::any_of(study_.recordings.begin(), study_.recordings.end(), same) ||
          std::any_of(study_.validation.begin(), study_.validation.end(), same))
        diagnostics_.Report(kBenchRecordingTwice, {file_, recording.line}, {recording.name});
      out.push_back(std::move(recording));
    }
  }

  BenchStudy::Recording ReadRecording(const YAML::Node& entry) {
    BenchStudy::Recording recording;
    recording.line = LineOf(entry);
    std::optional<std::string> name;
    if (entry.IsScalar()) {
      recording.file = Resolve(entry.Scalar());
    } else {
      const StrictMap map(
          entry, "the recording",
          {"name", "file", "control", "displacement", "force", "time", "start", "end", "resample", "bridge", "with"},
          file_, diagnostics_);
      map.Require("file");
      if (const auto file = map.Text("file")) recording.file = Resolve(*file);
      name = map.Text("name");
      recording.setting = ReadSetting(map);
      ReadPreparation(map, "recording '" + name.value_or(recording.file.stem().string()) + "'", recording);
    }
    recording.name = name.value_or(recording.file.stem().string());
    return recording;
  }

  void ReadPreparation(const StrictMap& map, const std::string& where, BenchStudy::Recording& recording) {
    recording.displacement = Channel(map, "displacement", " of " + where);
    recording.force = Channel(map, "force", " of " + where);
    recording.time = Channel(map, "time", " of " + where);
    recording.preparation = ReadTimePreparation(map, where);
    recording.window = ReadWindow(map, where, kBenchWindowEmpty);
  }

  std::filesystem::path Resolve(const std::string& path) const {
    return (std::filesystem::path(file_).parent_path() / path).lexically_normal();
  }

  std::string file_;
  Diagnostics& diagnostics_;
  BenchStudy study_;
};

}  // namespace

BenchStudy ReadBenchStudy(const YAML::Node& node, const std::string& file, Diagnostics& diagnostics) {
  return BenchReader(file, diagnostics).Read(node);
}

}  // namespace fourpost
