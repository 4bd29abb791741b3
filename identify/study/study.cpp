#include "identify/study/study.h"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/files/text_file.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/problems/test_problem.h"
#include "identify/refine/search_method_list.h"
#include "identify/study/experiment_kinds.h"
#include "identify/study/findings.h"
#include "identify/study_file/calibration_reader.h"
#include "identify/study_file/control_reader.h"
#include "identify/study_file/findings.h"
#include "identify/study_file/strict_yaml.h"
#include "identify/study_file/study_about.h"
#include "identify/study_file/study_yaml.h"

namespace fourpost {
namespace {

/// Of a study with a key of a kind that is alone, that kind; else null.
const ExperimentKind* AloneIn(const YAML::Node& root) {
  if (!root.IsMap()) return nullptr;
  for (const ExperimentKind& kind : ExperimentKinds())
    if (kind.is_alone && std::any_of(kind.keys.begin(), kind.keys.end(),
                                     [&](std::string_view key) { return root[std::string(key)].IsDefined(); }))
      return &kind;
  return nullptr;
}

/// Those that a study may have.
std::vector<const ExperimentKind*> KindsOf(const YAML::Node& root) {
  if (const ExperimentKind* alone = AloneIn(root)) return {alone};
  std::vector<const ExperimentKind*> kinds;
  for (const ExperimentKind& kind : ExperimentKinds())
    if (!kind.is_alone) kinds.push_back(&kind);
  return kinds;
}

class StudyReader {
 public:
  StudyReader(const std::filesystem::path& file, Diagnostics& diagnostics)
      : file_(file.string()), diagnostics_(diagnostics) {
    study_.file = file;
  }

  Study Read(const YAML::Node& root) {
    if (root.IsMap() && root["problem"].IsDefined()) return ReadTestProblem(root);
    const std::vector<const ExperimentKind*> kinds = KindsOf(root);
    const StrictMap top = Map(root, "the study", KeysOf(kinds));
    ReadVehicle(top);
    // For its report alone.
    ReadStudyAbout(top);
    for (const ExperimentKind* kind : kinds)
      if (std::unique_ptr<Experiment> experiment = kind->read(top)) study_.experiments.Add(std::move(experiment));
    RequireFitted(top);
    if (top.Has("free")) ReadFree(top.Get("free"));
    if (top.Has("start")) ReadStart(top.Get("start"));
    if (top.Has("control")) study_.control = ReadStudyControl(top.Get("control"), file_, diagnostics_);
    if (top.Has("calibration")) study_.calibrations = ReadCalibrations(top.Get("calibration"), file_, diagnostics_);
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
      Fault(top.Get("problem"), kProblemUnknown, {*study_.problem, SuggestLegal(*study_.problem, kTestProblems)});
    ReadSearches(top);
    return study_;
  }

  static std::vector<std::string_view> KeysOf(const std::vector<const ExperimentKind*>& kinds) {
    std::vector<std::string_view> keys = {"vehicle",     "about",  "free",   "start",  "control",
                                          "calibration", "search", "refine", "target", "methods"};
    for (const ExperimentKind* kind : kinds) keys.insert(keys.end(), kind->keys.begin(), kind->keys.end());
    return keys;
  }

  void ReadSearches(const StrictMap& top) {
    if (top.Has("search")) ReadSearch(top.Get("search"));
    study_.target_cost = top.Number("target", 0, 1e300);
    if (top.Has("methods")) ReadMethods(top.Get("methods"));
  }

  void ReadMethods(const YAML::Node& node) {
    if (!node.IsMap()) return Fault(node, kMethodsNotMapped);
    std::vector<std::string> names;
    for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
    const StrictMap unique = Map(node, "'methods'", {names.begin(), names.end()});
    for (const auto& entry : node) ReadMethod(entry.first.as<std::string>(), entry.second);
  }

  void ReadMethod(const std::string& name, const YAML::Node& node) {
    const std::string where = "method '" + name + "'";
    if (!node.IsMap()) return Fault(node, kMethodNotSettings, {where});
    std::vector<std::string> keys;
    for (const auto& entry : node) keys.push_back(entry.first.as<std::string>());
    const StrictMap map = Map(node, where, {keys.begin(), keys.end()});
    StudyMethod method = {.name = name, .line = LineOf(node)};
    const YAML::Node preset = map.Require("method");
    method.preset = Present(map.Text("method").value_or(""), preset);
    if (!method.preset.empty() &&
        std::find(kMethodNames.begin(), kMethodNames.end(), method.preset) == kMethodNames.end())
      Fault(preset, kMethodPresetUnknown, {method.preset, SuggestLegal(method.preset, kMethodNames)});
    for (const auto& entry : node) {
      const auto key = entry.first.as<std::string>();
      if (key == "method") continue;
      if (!entry.second.IsScalar()) Fault(entry.second, kSettingNotValue, {key, where});
      else method.settings.push_back({key, entry.second.Scalar(), LineOf(entry.second)});
    }
    study_.methods.push_back(method);
  }

  /// The present name of a method.
  std::string Present(const std::string& name, const YAML::Node& node) {
    const std::optional<std::string_view> present = PresentMethodName(name);
    if (!present) return name;
    Fault(node, kMethodFormer, {name, std::string(*present)});
    return std::string(*present);
  }

  /// Sines may all be kept for validation where something else is fitted.
  void RequireFitted(const StrictMap& top) {
    bool is_kept = false;
    for (const Experiment& experiment : study_.experiments)
      for (const ExperimentFile& file : experiment.Files()) {
        if (file.use == ExperimentFile::Use::kFitted) return;
        is_kept |= file.use == ExperimentFile::Use::kValidation;
      }
    if (is_kept && top.Has("recordings")) Fault(top.Get("recordings"), kSinesNotFitted);
  }

  StrictMap Map(const YAML::Node& node, const std::string& where, const std::vector<std::string_view>& keys) {
    return {node, where, keys, file_, diagnostics_};
  }

  void Fault(const YAML::Node& node, const Finding& finding, const std::vector<std::string>& words = {}) {
    diagnostics_.Report(finding, {file_, LineOf(node)}, words);
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

  std::vector<std::string> Names(const YAML::Node& node, const std::string& where) {
    std::vector<std::string> names;
    if (node.IsSequence())
      for (const YAML::Node& entry : node)
        if (entry.IsScalar()) names.push_back(entry.Scalar());
    if (names.empty() || names.size() != node.size()) Fault(node, kStudyNotNames, {where});
    return names;
  }

  void ReadFree(const YAML::Node& node) {
    study_.free_line = LineOf(node);
    if (!node.IsScalar()) {
      study_.free = Names(node, "'free'");
      return;
    }
    // A plain text in YAML: "all", or `all but [a, b]`.
    const auto behind = [](std::string_view text, std::string_view word) -> std::optional<std::string_view> {
      text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
      if (!text.starts_with(word)) return std::nullopt;
      return text.substr(word.size());
    };
    const std::optional<std::string_view> but = behind(node.Scalar(), "all");
    if (but && but->empty()) return;
    const std::optional<std::string_view> list = but ? behind(*but, "but") : std::nullopt;
    if (!list) return Fault(node, kFreeNotNames);
    const YAML::Node held = YAML::Load(std::string(*list));
    for (const YAML::Node& entry : held)
      if (entry.IsScalar()) study_.held.push_back(entry.Scalar());
    if (!held.IsSequence() || study_.held.size() != held.size() || study_.held.empty()) Fault(node, kFreeNotNames);
  }

  void ReadStart(const YAML::Node& node) {
    if (!node.IsMap() || node.size() == 0) return Fault(node, kStartNotMapped);
    std::vector<std::string> names;
    for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
    const StrictMap unique = Map(node, "'start'", {names.begin(), names.end()});
    for (const auto& entry : node) {
      if (entry.second.IsScalar())
        study_.start.push_back({entry.first.as<std::string>(), entry.second.Scalar(), LineOf(entry.second)});
      else Fault(entry.second, kStartNotMapped);
    }
  }

  void ReadRefine(const YAML::Node& node) {
    const StrictMap map = Map(node, "'refine'", {"loss", "scale"});
    map.Require("loss");
    study_.refine.scale = map.Number("scale", 1e-6, 1e6);
    const std::optional<std::string> name = map.Text("loss");
    if (!name) return;
    const auto* const found = std::find(kLossNames.begin(), kLossNames.end(), *name);
    if (found == kLossNames.end())
      return Fault(map.Get("loss"), kLossUnknown, {*name, SuggestLegal(*name, kLossNames)});
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
    if (search.deadline_s == 0) map.FaultOf("deadline", kKeyNotPositive);
  }

  std::string file_;
  Diagnostics& diagnostics_;
  Study study_;
};

}  // namespace

std::optional<Study> ReadStudy(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadTextFile(file, diagnostics);
  return text ? ReadStudyText(*text, file, diagnostics) : std::nullopt;
}

std::optional<Study> ReadStudyText(const std::string& text, const std::filesystem::path& file,
                                   Diagnostics& diagnostics) {
  const std::optional<YAML::Node> root = ReadYaml(text, file.string(), diagnostics);
  if (!root) return std::nullopt;
  std::optional<Study> study;
  try {
    study = StudyReader(file, diagnostics).Read(*root);
    study->text = text;
  } catch (const YAML::Exception& error) {
    diagnostics.Report(kStudyNotYaml, {file.string(), error.mark.is_null() ? 0 : error.mark.line + 1}, {error.msg});
  }
  if (diagnostics.HasErrors()) return std::nullopt;
  return study;
}

}  // namespace fourpost
