#include "identify/study.h"

#include <algorithm>
#include <cmath>

#include "analysis/text_file.h"
#include "identify/channel_source_reader.h"
#include "identify/problems/test_problem.h"
#include "identify/search_method_list.h"
#include "identify/strict_yaml.h"
#include "identify/study_yaml.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost {
namespace {

class StudyReader {
 public:
  StudyReader(const std::filesystem::path& file, Diagnostics& diagnostics)
      : file_(file.string()), diagnostics_(diagnostics) {
    study_.file = file;
  }

  Study Read(const YAML::Node& root) {
    if (root.IsMap() && root["problem"].IsDefined()) return ReadTestProblem(root);
    if (root.IsMap() && root["bench"].IsDefined()) return ReadBench(root);
    const StrictMap top = Map(root, "the study",
                              {"vehicle", "recordings", "channels", "static_loads", "free", "band", "model_error",
                               "search", "refine", "target", "methods", "histories", "cost"});
    ReadVehicle(top);
    if (top.Has("histories")) ReadHistories(top);
    const bool has_responses = HistoriesOf(study_.histories, false).empty() || top.Has("recordings");
    if (has_responses) ReadResponses(top);
    if (top.Has("static_loads")) ReadStaticLoads(top.Get("static_loads"));
    if (top.Has("free")) ReadFree(top.Get("free"));
    if (top.Has("model_error")) ReadModelError(top.Get("model_error"));
    if (top.Has("refine")) ReadRefine(top.Get("refine"));
    ReadSearches(top);
    return study_;
  }

 private:
  Study ReadTestProblem(const YAML::Node& root) {
    const StrictMap top = Map(root, "the study", {"problem", "search", "target", "methods"});
    study_.problem = top.Text("problem");
    study_.problem_line = LineOf(top.Get("problem"));
    const auto known = [&](std::string_view name) { return name == study_.problem; };
    if (study_.problem && std::none_of(kTestProblems.begin(), kTestProblems.end(), known))
      Fault(top.Get("problem"),
            "unknown problem '" + *study_.problem + "'" + Suggestion(*study_.problem, kTestProblems));
    ReadSearches(top);
    return study_;
  }

  void ReadResponses(const StrictMap& top) {
    ReadRecordings(top);
    if (const YAML::Node channels = top.Require("channels"); channels.IsDefined())
      study_.channels =
          ReadChannelSources(channels, "'channels'", "sensors", ChannelKind::kSteppedSine, file_, diagnostics_);
    ReadBand(top);
  }

  void ReadHistories(const StrictMap& top) {
    study_.histories = fourpost::ReadHistories(top.Get("histories"), study_.file, diagnostics_);
    const std::optional<std::string> cost = top.Text("cost");
    if (!cost) return;
    const auto* const found = std::find(kHistoryCostNames.begin(), kHistoryCostNames.end(), *cost);
    if (found == kHistoryCostNames.end())
      return Fault(top.Get("cost"), "unknown cost '" + *cost + "'" + Suggestion(*cost, kHistoryCostNames));
    study_.history_cost = static_cast<HistoryCost>(found - kHistoryCostNames.begin());
  }

  Study ReadBench(const YAML::Node& root) {
    const StrictMap top = Map(root, "the study", {"vehicle", "bench", "free", "search", "refine", "target", "methods"});
    ReadVehicle(top);
    study_.bench = ReadBenchStudy(top.Get("bench"), file_, diagnostics_);
    if (top.Has("free")) ReadFree(top.Get("free"));
    if (top.Has("refine")) ReadRefine(top.Get("refine"));
    ReadSearches(top);
    return study_;
  }

  void ReadSearches(const StrictMap& top) {
    if (top.Has("search")) ReadSearch(top.Get("search"));
    study_.target_cost = top.Number("target", 0, 1e300);
    if (top.Has("methods")) ReadMethods(top.Get("methods"));
  }

  void ReadMethods(const YAML::Node& node) {
    if (!node.IsMap()) return Fault(node, "'methods' must map names to settings");
    std::vector<std::string> names;
    for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
    const StrictMap unique = Map(node, "'methods'", {names.begin(), names.end()});
    for (const auto& entry : node) ReadMethod(entry.first.as<std::string>(), entry.second);
  }

  void ReadMethod(const std::string& name, const YAML::Node& node) {
    const std::string where = "method '" + name + "'";
    if (!node.IsMap()) return Fault(node, where + " must be a list of settings");
    std::vector<std::string> keys;
    for (const auto& entry : node) keys.push_back(entry.first.as<std::string>());
    const StrictMap map = Map(node, where, {keys.begin(), keys.end()});
    StudyMethod method = {.name = name, .line = LineOf(node)};
    const YAML::Node preset = map.Require("method");
    method.preset = map.Text("method").value_or("");
    if (!method.preset.empty() &&
        std::find(kMethodNames.begin(), kMethodNames.end(), method.preset) == kMethodNames.end())
      Fault(preset, "unknown method '" + method.preset + "'" + Suggestion(method.preset, kMethodNames));
    for (const auto& entry : node) {
      const auto key = entry.first.as<std::string>();
      if (key == "method") continue;
      if (!entry.second.IsScalar()) Fault(entry.second, "'" + key + "' of " + where + " must be a single value");
      else method.settings.push_back({key, entry.second.Scalar(), LineOf(entry.second)});
    }
    study_.methods.push_back(method);
  }

  StrictMap Map(const YAML::Node& node, const std::string& where, const std::vector<std::string_view>& keys) {
    return {node, where, keys, file_, diagnostics_};
  }

  void Fault(const YAML::Node& node, std::string message) {
    diagnostics_.Error(file_, LineOf(node), std::move(message));
  }

  std::filesystem::path Resolve(const std::string& path) const {
    return (std::filesystem::path(file_).parent_path() / path).lexically_normal();
  }

  void ReadVehicle(const StrictMap& top) {
    const YAML::Node node = top.Require("vehicle");
    if (const std::optional<std::string> vehicle = top.Text("vehicle")) {
      study_.vehicle = Resolve(*vehicle);
      study_.vehicle_line = LineOf(node);
    }
  }

  void ReadRecordings(const StrictMap& top) {
    const YAML::Node list = top.Require("recordings");
    if (!list.IsDefined()) return;
    if (!list.IsSequence() || list.size() == 0) {
      Fault(list, "'recordings' must be a list with at least one entry");
      return;
    }
    for (const YAML::Node& entry : list) {
      const StrictMap map = Map(entry, "the recording", {"name", "file", "posts"});
      StudyRecording recording;
      recording.line = map.line();
      map.Require("file");
      if (const auto file = map.Text("file")) recording.file = Resolve(*file);
      recording.name = map.Text("name").value_or(recording.file.stem().string());
      if (const YAML::Node posts = map.Require("posts"); posts.IsDefined()) ReadPosts(posts, recording);
      for (const StudyRecording& other : study_.recordings)
        if (other.name == recording.name) Fault(entry, "two recordings are called '" + recording.name + "'");
      study_.recordings.push_back(recording);
    }
  }

  void ReadPosts(const YAML::Node& node, StudyRecording& recording) {
    if (node.IsScalar()) recording.pattern = Pattern(node);
    else recording.posts = Shape(node);
  }

  std::string Pattern(const YAML::Node& node) {
    const std::string& name = node.Scalar();
    if (std::find(kPostPatterns.begin(), kPostPatterns.end(), name) == kPostPatterns.end())
      Fault(node, "unknown pattern '" + name + "' of 'posts'" + Suggestion(name, kPostPatterns));
    return name;
  }

  std::vector<std::pair<std::string, double>> Shape(const YAML::Node& node) {
    std::vector<std::pair<std::string, double>> shape;
    if (!node.IsMap() || node.size() == 0) {
      Fault(node,
            "'posts' must be a pattern such as pitch, or map each moving post to its share of the motion, such as "
            "{front: 1, rear: -1}");
      return shape;
    }
    std::vector<std::string> names;
    for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
    const StrictMap map = Map(node, "'posts'", {names.begin(), names.end()});
    for (const std::string& name : names)
      if (const auto share = map.Number(name, -1, 1)) shape.emplace_back(name, *share);
    const auto is_reference = [](const auto& post) { return std::abs(post.second) == 1; };
    if (shape.size() == names.size() && std::none_of(shape.begin(), shape.end(), is_reference))
      Fault(node, "one of the 'posts' must be the reference and have the share 1 or -1");
    return shape;
  }

  std::vector<std::string> Names(const YAML::Node& node, const std::string& where) {
    std::vector<std::string> names;
    if (node.IsSequence())
      for (const YAML::Node& entry : node)
        if (entry.IsScalar()) names.push_back(entry.Scalar());
    if (names.empty() || names.size() != node.size()) Fault(node, where + " must be a list of names");
    return names;
  }

  void ReadStaticLoads(const YAML::Node& node) {
    const StrictMap map = Map(node, "'static_loads'", {"file", "tyres"});
    map.Require("file");
    if (const auto file = map.Text("file")) study_.static_loads_file = Resolve(*file);
    if (const YAML::Node tyres = map.Require("tyres"); tyres.IsDefined())
      study_.static_loads = ReadChannelSources(tyres, "'tyres'", "tyres", ChannelKind::kLoad, file_, diagnostics_);
  }

  void ReadFree(const YAML::Node& node) {
    study_.free = Names(node, "'free'");
    study_.free_line = LineOf(node);
  }

  void ReadBand(const StrictMap& top) {
    const YAML::Node node = top.Require("band");
    if (!node.IsDefined()) return;
    study_.band_line = LineOf(node);
    if (!node.IsSequence() || node.size() != 2) {
      Fault(node, "'band' must be a list of two frequencies such as [0.5 Hz, 12 Hz]");
      return;
    }
    const auto lower = ReadQuantity(node[0], kFrequency, "the lower end of 'band'", file_, diagnostics_);
    const auto upper = ReadQuantity(node[1], kFrequency, "the upper end of 'band'", file_, diagnostics_);
    if (!lower || !upper) return;
    if (!(*lower >= 0 && *lower < *upper)) Fault(node, "'band' is empty: its lower end must be below its upper end");
    // Beyond what any rig or vehicle does.
    if (*upper > 1e5) Fault(node, "'band' ends above 100 kHz; give frequencies in Hz that the recordings have");
    study_.band_lower_Hz = *lower;
    study_.band_upper_Hz = *upper;
  }

  void ReadModelError(const YAML::Node& node) {
    const StrictMap map =
        Map(node, "'model_error'", {"gain_dB", "phase", "mean", "second_harmonic", "floor", "history"});
    ModelError& error = study_.model_error;
    error.gain_dB = map.Number("gain_dB", 0, 100).value_or(error.gain_dB);
    error.phase_rad = map.Quantity("phase", kDimensionless, 0).value_or(error.phase_rad);
    error.floor = map.Number("floor", 0, 1).value_or(error.floor);
    error.mean_m = map.Quantity("mean", kLength, 0).value_or(error.mean_m);
    error.second_harmonic_m = map.Quantity("second_harmonic", kLength, 0).value_or(error.second_harmonic_m);
    error.history = map.Quantity("history", kDimensionless, 0).value_or(error.history);
    if (error.mean_m == 0) map.Fault(map.Get("mean"), "'mean' of 'model_error' must be above zero");
  }

  void ReadRefine(const YAML::Node& node) {
    const StrictMap map = Map(node, "'refine'", {"loss", "scale"});
    map.Require("loss");
    study_.refine.scale = map.Number("scale", 1e-6, 1e6);
    const std::optional<std::string> name = map.Text("loss");
    if (!name) return;
    const auto* const found = std::find(kLossNames.begin(), kLossNames.end(), *name);
    if (found == kLossNames.end())
      return Fault(map.Get("loss"), "unknown loss '" + *name + "'" + Suggestion(*name, kLossNames));
    study_.refine.loss = static_cast<LossKind>(found - kLossNames.begin());
  }

  void ReadSearch(const YAML::Node& node) {
    const StrictMap map =
        Map(node, "'search'",
            {"seed", "method", "evaluations", "population", "starts", "generations", "stagnation", "time", "deadline"});
    StudySearch& search = study_.search;
    search.seed = static_cast<std::uint64_t>(map.Integer("seed", 0, 1L << 62).value_or(static_cast<long>(search.seed)));
    search.evaluations = map.Integer("evaluations", 1, 1000000000);
    search.method = map.Text("method").value_or(search.method);
    search.method_line = map.Has("method") ? LineOf(map.Get("method")) : map.line();
    if (const auto population = map.Integer("population", 4, 100000)) search.population = static_cast<int>(*population);
    search.stagnation = static_cast<int>(map.Integer("stagnation", 1, 1L << 30).value_or(search.stagnation));
    search.time_s = map.Quantity("time", kTime, 0).value_or(search.time_s);
    search.generations = static_cast<int>(map.Integer("generations", 1, 1L << 30).value_or(search.generations));
    search.starts = static_cast<int>(map.Integer("starts", 1, 1000).value_or(search.starts));
    search.deadline_s = map.Quantity("deadline", kTime, 0).value_or(search.deadline_s);
    if (search.deadline_s == 0) map.Fault(map.Get("deadline"), "'deadline' of 'search' must be above zero");
  }

  std::string file_;
  Diagnostics& diagnostics_;
  Study study_;
};

}  // namespace

std::optional<Study> ReadStudy(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadTextFile(file, diagnostics);
  if (!text) return std::nullopt;
  const std::optional<YAML::Node> root = ReadYaml(*text, file.string(), diagnostics);
  if (!root) return std::nullopt;
  std::optional<Study> study;
  try {
    study = StudyReader(file, diagnostics).Read(*root);
    study->text = *text;
  } catch (const YAML::Exception& error) {
    diagnostics.Error(file.string(), error.mark.is_null() ? 0 : error.mark.line + 1, "not YAML: " + error.msg);
  }
  if (diagnostics.HasErrors()) return std::nullopt;
  return study;
}

}  // namespace fourpost
