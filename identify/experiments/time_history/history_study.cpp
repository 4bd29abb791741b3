#include "identify/experiments/time_history/history_study.h"

#include <algorithm>
#include <iterator>

#include "analysis/files/recorded_table.h"
#include "analysis/text/named.h"
#include "analysis/text/number.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/study_file/channel_source_reader.h"
#include "identify/study_file/control_reader.h"
#include "identify/study_file/findings.h"
#include "identify/study_file/named_channels.h"
#include "identify/study_file/preparation_reader.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {
namespace {

class HistoryReader {
 public:
  HistoryReader(std::filesystem::path study, YAML::Node channels, Diagnostics& diagnostics)
      : study_(std::move(study)), file_(study_.string()), channels_(std::move(channels)), diagnostics_(diagnostics) {}

  StudyHistory Read(const YAML::Node& node) {
    const StrictMap map = Map(node, "the history",
                              {"name", "file", "posts", "channels", "filter", "noise", "process", "start", "end", "use",
                               "time", "resample", "bridge", "with", "heights", "release", "control", "actuators"});
    StudyHistory history;
    history.line = map.line();
    map.Require("file");
    if (const auto file = map.Text("file")) history.file = (study_.parent_path() / *file).lexically_normal();
    history.name = map.Text("name").value_or(history.file.stem().string());
    where_ = "history '" + history.name + "'";
    if (map.Has("time"))
      history.time =
          ReadSourceChannel(map.Get("time"), "'time' of " + where_, ChannelKind::kHistory, file_, diagnostics_);
    if (map.Has("release")) history.release = ReadRelease(map);
    history.has_posts_by_name = !map.Has("posts") && !history.release && !map.Has("actuators");
    history.posts = ReadChannelSources(map.Get("posts"), "'posts' of " + where_, "posts", ChannelKind::kHistory, file_,
                                       diagnostics_);
    const YAML::Node channels = map.Has("channels") ? map.Get("channels") : channels_;
    history.takes_others_by_name = TakesOthersByName(channels);
    history.channels =
        ReadChannelSources(channels, "'channels' of " + where_, "sensors", ChannelKind::kHistory, file_, diagnostics_);
    history.setting = ReadSetting(map);
    if (map.Has("actuators")) ReadActuators(map.Get("actuators"), history);
    if (map.Has("filter")) history.filter = Filter(map.Get("filter"));
    if (map.Has("noise")) history.noise = Noise(map.Get("noise"));
    history.process_sd = map.Quantity("process", kAcceleration, 0);
    if (history.process_sd && *history.process_sd == 0)
      map.Fault(map.Get("process"), kKeyNotPositive, {"'process' of " + where_});
    if (const auto use = map.Text("use")) {
      history.is_validation = *use == "validation";
      if (*use != "fit" && *use != "validation") map.Fault(map.Get("use"), kHistoryUse, {where_});
    }
    ReadPreparation(map, history);
    const RecordingWindow window = ReadWindow(map, where_, kHistoryWindowEmpty);
    history.start_s = window.start_s;
    history.end_s = window.end_s;
    return history;
  }

 private:
  StrictMap Map(const YAML::Node& node, const std::string& where, const std::vector<std::string_view>& keys) {
    return {node, where, keys, file_, diagnostics_};
  }

  void ReadPreparation(const StrictMap& map, StudyHistory& history) {
    history.preparation = ReadTimePreparation(map, where_);
    if (const auto heights = map.Text("heights")) {
      history.has_absolute_heights = *heights == "absolute";
      if (!history.has_absolute_heights) map.Fault(map.Get("heights"), kHistoryHeights, {where_});
    }
  }

  /// A mapping of names that are not known here.
  std::vector<std::string> Keys(const YAML::Node& node, const std::string& where) {
    std::vector<std::string> names;
    for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
    const StrictMap unique = Map(node, where, {names.begin(), names.end()});
    return names;
  }

  /// "estimated", "at rest", or readings of sensors at which it was held.
  Release ReadRelease(const StrictMap& map) {
    const YAML::Node node = map.Get("release");
    Release release;
    if (node.IsScalar()) {
      const std::string from = node.Scalar();
      if (from == "at rest") release.from = Release::From::kRest;
      else if (from != "estimated") map.Fault(node, kReleaseUnknown, {where_, from});
      return release;
    }
    release.from = Release::From::kHeld;
    if (!node.IsMap() || node.size() == 0) {
      map.Fault(node, kReleaseUnknown, {where_, "no text and no mapping"});
      return release;
    }
    const std::string where = "'release' of " + where_;
    for (const std::string& sensor : Keys(node, where)) {
      Release::Hold hold{.sensor = sensor, .line = LineOf(node[sensor])};
      if (!node[sensor].IsScalar() || node[sensor].Scalar() != "estimated")
        hold.reading_m =
            ReadQuantity(node[sensor], kLength, "'" + sensor + "' of " + where, file_, diagnostics_).value_or(0);
      release.held.push_back(std::move(hold));
    }
    return release;
  }

  /// Channels, and constant forces.
  void ReadActuators(const YAML::Node& node, StudyHistory& history) {
    YAML::Node channels = YAML::Clone(node);
    for (const auto& entry : node) {
      const std::optional<Quantity> load =
          entry.second.IsScalar() ? ParseQuantity(entry.second.Scalar()) : std::nullopt;
      if (!load || load->unit.dimension != kForce) continue;
      history.loads_N.emplace_back(entry.first.as<std::string>(), load->si);
      channels.remove(entry.first.as<std::string>());
    }
    if (channels.size() > 0 || node.size() == 0)
      history.actuators = ReadChannelSources(channels, "'actuators' of " + where_, "actuators", ChannelKind::kHistory,
                                             file_, diagnostics_);
    // A clone has no lines.
    for (auto& [name, source] : history.actuators) source.line = LineOf(node[name]);
  }

  std::optional<LowPassDesign> Filter(const YAML::Node& node) {
    const StrictMap map = Map(node, "'filter' of " + where_, {"order", "cutoff"});
    map.Require("order");
    map.Require("cutoff");
    const auto order = map.Integer("order", 1, 16);
    const auto cutoff = map.Quantity("cutoff", kFrequency, 1e-6);
    if (!order || !cutoff) return std::nullopt;
    return LowPassDesign{.order = static_cast<int>(*order), .cutoff_Hz = *cutoff};
  }

  std::vector<StudyNoise> Noise(const YAML::Node& node) {
    std::vector<StudyNoise> noise;
    const std::string where = "'noise' of " + where_;
    if (!node.IsMap() || node.size() == 0) {
      diagnostics_.Report(kNoiseNotMapped, {file_, LineOf(node)}, {where});
      return noise;
    }
    for (const std::string& name : Keys(node, where))
      noise.push_back({name, node[name].IsScalar() ? node[name].Scalar() : "", LineOf(node[name])});
    return noise;
  }

  std::filesystem::path study_;
  std::string file_;
  std::string where_;
  /// Of histories that have none.
  YAML::Node channels_;
  Diagnostics& diagnostics_;
};

/// Of a post among the columns of a recording.
std::optional<std::string> ChannelOfPost(const std::string& post, std::size_t posts,
                                         const std::vector<std::string>& recorded) {
  for (const std::string& name : {post, "post_" + post})
    if (std::find(recorded.begin(), recorded.end(), name) != recorded.end()) return name;
  const auto is_post = [](const std::string& name) { return name.starts_with("post"); };
  if (posts != 1 || std::count_if(recorded.begin(), recorded.end(), is_post) != 1) return std::nullopt;
  return *std::find_if(recorded.begin(), recorded.end(), is_post);
}

}  // namespace

void MapByName(const Vehicle& vehicle, StudyHistory& history) {
  if (!history.has_posts_by_name && !history.takes_others_by_name) return;
  Diagnostics left_to_loading;
  const std::optional<RecordedTable> table = ReadRecordedTable(history.file, left_to_loading);
  if (!table) return;
  std::vector<std::string> recorded = table->names();
  for (const OtherFile& other : history.preparation.others)
    if (const std::optional<RecordedTable> beside = ReadRecordedTable(other.path, left_to_loading))
      recorded.insert(recorded.end(), beside->names().begin(), beside->names().end());
  if (history.has_posts_by_name)
    for (const Post& post : vehicle.posts)
      if (const auto channel = ChannelOfPost(post.name, vehicle.posts.size(), recorded))
        history.posts.emplace_back(post.name,
                                   ChannelSource{.channels = {SourceChannel(*channel)}, .line = history.line});
  if (history.takes_others_by_name) AddByName(NamesOf(vehicle.sensors), recorded, history.line, history.channels);
  history.has_posts_by_name = history.takes_others_by_name = false;
}

std::vector<StudyHistory> HistoriesOf(const std::vector<StudyHistory>& all, bool validation) {
  std::vector<StudyHistory> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const StudyHistory& history) { return history.is_validation == validation; });
  return some;
}

std::vector<StudyHistory> ReadHistories(const YAML::Node& list, const YAML::Node& channels,
                                        const std::filesystem::path& study, Diagnostics& diagnostics) {
  std::vector<StudyHistory> histories;
  if (!list.IsSequence() || list.size() == 0) {
    diagnostics.Report(kHistoriesEmpty, {study.string(), LineOf(list)});
    return histories;
  }
  for (const YAML::Node& node : list) {
    StudyHistory history = HistoryReader(study, channels, diagnostics).Read(node);
    for (const StudyHistory& other : histories)
      if (other.name == history.name) diagnostics.Report(kHistoryTwice, {study.string(), history.line}, {history.name});
    histories.push_back(std::move(history));
  }
  return histories;
}

}  // namespace fourpost
