#include "identify/experiments/four_post/four_post.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "identify/experiments/four_post/findings.h"
#include "identify/study_file/channel_source_reader.h"
#include "identify/study_file/named_channels.h"
#include "identify/study_file/preparation_reader.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost {
namespace {

/// Of posts that are moved at all.
constexpr double kSmallestAmplitude_m = 1e-9;

class FourPostReader {
 public:
  explicit FourPostReader(const StrictMap& study) : study_(study), file_(study.file()) { plan_.file = file_; }

  FourPostPlan Read() {
    ReadRecordings(study_);
    const YAML::Node channels = study_.Get("channels");
    plan_.channels_line = study_.LineOfKey("channels");
    plan_.takes_others_by_name = TakesOthersByName(channels);
    if (channels.IsDefined())
      plan_.channels =
          ReadChannelSources(channels, "'channels'", "sensors", ChannelKind::kHistory, file_, study_.diagnostics());
    ReadBand(study_);
    plan_.model_error = ReadModelError(study_);
    return std::move(plan_);
  }

 private:
  void ReadRecordings(const StrictMap& top) {
    const YAML::Node list = top.Require("recordings");
    if (!list.IsDefined()) return;
    if (!list.IsSequence() || list.size() == 0) {
      Fault(list, kSinesEmpty);
      return;
    }
    for (const YAML::Node& entry : list) {
      const StrictMap map = Map(entry, "the recording",
                                {"name", "file", "posts", "repeats", "amplitude", "post_channels", "filter", "resample",
                                 "bridge", "with", "time", "start", "end", "use"});
      StudyRecording recording;
      recording.line = map.line();
      map.Require("file");
      if (const auto file = map.Text("file")) recording.file = study_.Resolve(*file);
      recording.name = map.Text("name").value_or(recording.file.stem().string());
      recording.repeats = static_cast<int>(map.Integer("repeats", 1, 1000).value_or(1));
      recording.amplitude_m = map.Quantity("amplitude", kLength, kSmallestAmplitude_m);
      if (const YAML::Node posts = map.Require("posts"); posts.IsDefined()) ReadPosts(posts, recording);
      if (map.Has("post_channels")) ReadPostChannels(map.Get("post_channels"), recording);
      if (map.Has("filter")) recording.filter = Filter(map.Get("filter"));
      ReadTimes(map, recording);
      for (const std::vector<StudyRecording>* const others : {&plan_.recordings, &plan_.validation})
        for (const StudyRecording& other : *others)
          if (other.name == recording.name) Fault(entry, kSineTwice, {recording.name});
      const std::string use = map.Text("use").value_or("fit");
      if (use != "fit" && use != "validation")
        map.Fault(map.Get("use"), kSineUse, {"recording '" + recording.name + "'"});
      (use == "validation" ? plan_.validation : plan_.recordings).push_back(std::move(recording));
    }
  }

  void ReadTimes(const StrictMap& map, StudyRecording& recording) {
    const std::string where = "recording '" + recording.name + "'";
    recording.preparation = ReadTimePreparation(map, where);
    if (map.Has("time"))
      recording.time =
          ReadSourceChannel(map.Get("time"), "'time' of " + where, ChannelKind::kHistory, file_, study_.diagnostics());
    const RecordingWindow window = ReadWindow(map, where, kSineWindowEmpty);
    recording.start_s = window.start_s;
    recording.end_s = window.end_s;
  }

  void ReadPosts(const YAML::Node& node, StudyRecording& recording) {
    if (node.IsScalar()) recording.pattern = Pattern(node);
    else recording.posts = Shape(node);
  }

  std::string Pattern(const YAML::Node& node) {
    const std::string name(PatternName(node.Scalar()));
    if (std::find(kPostPatterns.begin(), kPostPatterns.end(), name) == kPostPatterns.end())
      Fault(node, kSinePatternUnknown, {name, SuggestLegal(name, kPostPatternNames)});
    return name;
  }

  std::vector<std::pair<std::string, double>> Shape(const YAML::Node& node) {
    std::vector<std::pair<std::string, double>> shape;
    if (!node.IsMap() || node.size() == 0) {
      Fault(node, kPostSharesMissing);
      return shape;
    }
    std::vector<std::string> names;
    for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
    const StrictMap map = Map(node, "'posts'", {names.begin(), names.end()});
    for (const std::string& name : names)
      if (const auto share = map.Number(name, -1, 1)) shape.emplace_back(name, *share);
    const auto is_reference = [](const auto& post) { return std::abs(post.second) == 1; };
    if (shape.size() == names.size() && std::none_of(shape.begin(), shape.end(), is_reference))
      Fault(node, kPostReferenceMissing);
    return shape;
  }

  /// Of a mapping from posts to channels of a time history.
  void ReadPostChannels(const YAML::Node& node, StudyRecording& recording) {
    if (!node.IsMap() || node.size() == 0) {
      Fault(node, kSinePostChannels);
      return;
    }
    for (const auto& entry : node) {
      const auto post = entry.first.as<std::string>();
      SourceChannel channel = ReadSourceChannel(entry.second, "'" + post + "' of 'post_channels'",
                                                ChannelKind::kHistory, file_, study_.diagnostics());
      recording.post_channels.push_back({channel.name, post});
      recording.post_sources.push_back(std::move(channel));
    }
  }

  std::optional<AcquisitionFilter> Filter(const YAML::Node& node) {
    const StrictMap map = Map(node, "'filter'", {"order", "cutoff"});
    map.Require("order");
    map.Require("cutoff");
    const auto order = map.Integer("order", 1, 16);
    const auto cutoff = map.Quantity("cutoff", kFrequency, 1e-6);
    if (!order || !cutoff) return std::nullopt;
    return AcquisitionFilter{.order = static_cast<int>(*order), .cutoff_Hz = *cutoff};
  }

  void ReadBand(const StrictMap& top) {
    const YAML::Node node = top.Require("band");
    if (!node.IsDefined()) return;
    plan_.band_line = LineOf(node);
    if (!node.IsSequence() || node.size() != 2) {
      Fault(node, kBandNotPair);
      return;
    }
    const auto lower = ReadQuantity(node[0], kFrequency, "the lower end of 'band'", file_, study_.diagnostics());
    const auto upper = ReadQuantity(node[1], kFrequency, "the upper end of 'band'", file_, study_.diagnostics());
    if (!lower || !upper) return;
    if (!(*lower >= 0 && *lower < *upper)) Fault(node, kBandEmpty);
    // Beyond what any rig or vehicle does.
    if (*upper > 1e5) Fault(node, kBandTooHigh);
    plan_.band_lower_Hz = *lower;
    plan_.band_upper_Hz = *upper;
  }

  StrictMap Map(const YAML::Node& node, const std::string& where, const std::vector<std::string_view>& keys) {
    return {node, where, keys, file_, study_.diagnostics()};
  }

  void Fault(const YAML::Node& node, const Finding& finding, const std::vector<std::string>& words = {}) {
    study_.diagnostics().Report(finding, {file_, LineOf(node)}, words);
  }

  const StrictMap& study_;
  std::string file_;
  FourPostPlan plan_;
};

}  // namespace

std::unique_ptr<Experiment> FourPost::Read(const StrictMap& study) {
  return std::make_unique<FourPost>(FourPostReader(study).Read(), std::vector<MeasuredRun>());
}

}  // namespace fourpost
