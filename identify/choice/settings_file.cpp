#include "identify/choice/settings_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "analysis/files/text_file.h"
#include "analysis/text/known_names.h"
#include "analysis/text/number.h"
#include "identify/choice/findings.h"
#include "identify/choice/knob_reader.h"
#include "identify/study_file/frequency_band.h"
#include "identify/study_file/strict_yaml.h"
#include "identify/study_file/study_yaml.h"
#include "vehicles/posts/road.h"

namespace fourpost {
namespace {

constexpr std::size_t kMostObjectives = 2;

std::string ScalarOf(const YAML::Node& node) { return node.IsScalar() ? node.Scalar() : ""; }

/// What a country road and a bad one ask of a car.
std::vector<ChoiceRoad> UsualRoads() {
  return {{.name = "B 80 km/h", .road_class = "B", .speed = 80 / 3.6, .weight = 0.5},
          {.name = "C 50 km/h", .road_class = "C", .speed = 50 / 3.6, .weight = 0.5}};
}

class SettingsReader {
 public:
  SettingsReader(const std::filesystem::path& file, const Vehicle& vehicle, const std::vector<Metric>& metrics,
                 Diagnostics& diagnostics)
      : vehicle_(vehicle), metrics_(metrics), diagnostics_(diagnostics) {
    settings_.file = file;
  }

  SettingsFile Read(const YAML::Node& root) {
    const StrictMap top(root, "the settings",
                        {"knobs", "roads", "objectives", "limits", "certainty", "band", "duration", "draws", "seed",
                         "shortlist", "agreement", "repeatability"},
                        settings_.file.string(), diagnostics_);
    settings_.knobs = ReadKnobs(top, vehicle_);
    ReadRoads(top);
    ReadObjectives(top);
    ReadLimits(top);
    if (top.Has("certainty")) settings_.certainty = ShareOf(top, "certainty");
    if (const auto band = top.Has("band") ? ReadFrequencyBand(top) : std::nullopt) {
      settings_.lower_Hz = band->lower_Hz;
      settings_.upper_Hz = band->upper_Hz;
    }
    constexpr double kShortest_s = 5;
    settings_.duration_s = top.Quantity("duration", kTime, kShortest_s).value_or(settings_.duration_s);
    settings_.draws = static_cast<std::size_t>(top.Integer("draws", 20, 10000).value_or(100));
    settings_.seed = static_cast<std::uint64_t>(top.Integer("seed", 0, 1L << 62).value_or(1));
    settings_.shortlist = static_cast<std::size_t>(top.Integer("shortlist", 1, 100).value_or(3));
    if (top.Has("agreement")) settings_.agreement = ShareOf(top, "agreement");
    if (top.Has("repeatability")) settings_.repeatability = ShareOf(top, "repeatability");
    return std::move(settings_);
  }

 private:
  double ShareOf(const StrictMap& map, std::string_view key) {
    const std::string text = ScalarOf(map.Get(key));
    const std::optional<Quantity> quantity = ParseQuantity(text);
    if (quantity && quantity->unit_text == "%" && quantity->si > 0 && quantity->si <= 1) return quantity->si;
    map.FaultOf(key, kSettingsShare);
    return 1;
  }

  void ReadRoads(const StrictMap& top) {
    if (!top.Has("roads")) {
      settings_.roads = UsualRoads();
      return;
    }
    const YAML::Node node = top.Get("roads");
    if (!node.IsSequence() || node.size() == 0) return top.Fault(node, kRoadsNone);
    double sum = 0;
    std::set<std::string> names;
    for (const YAML::Node& entry : node) {
      const StrictMap map(entry, "road", {"class", "speed", "weight", "name"}, top.file(), diagnostics_);
      if (!entry.IsMap()) continue;
      ChoiceRoad road = ReadRoad(map);
      sum += road.weight;
      if (!names.insert(road.name).second) map.Fault(entry, kRoadTwice, {road.name});
      settings_.roads.push_back(std::move(road));
    }
    for (ChoiceRoad& road : settings_.roads) road.weight /= sum;
  }

  static ChoiceRoad ReadRoad(const StrictMap& map) {
    ChoiceRoad road{.name = "", .road_class = "", .line = map.line()};
    const YAML::Node class_node = map.Require("class");
    if (class_node.IsDefined()) {
      road.road_class = map.Text("class").value_or("");
      if (!RoadRoughness(road.road_class))
        map.Fault(class_node, kRoadClass, {road.road_class, SuggestLegal(road.road_class, kRoadClasses)});
    }
    map.Require("speed");
    constexpr double kLeastSpeed = 0.1;
    road.speed = map.Quantity("speed", kVelocity, kLeastSpeed).value_or(1);
    road.weight = map.Number("weight", 1e-6, 1e6).value_or(1);
    road.name = map.Text("name").value_or(road.road_class + ' ' + ScalarOf(map.Get("speed")));
    return road;
  }

  std::optional<std::size_t> MetricOf(const StrictMap& map, const YAML::Node& node, const std::string& name) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < metrics_.size(); ++i) {
      if (metrics_[i].name == name) return i;
      names.push_back(metrics_[i].name);
    }
    map.Fault(node, kMetricUnknown, {name, KnownNames(name, names)});
    return std::nullopt;
  }

  void AddObjective(const StrictMap& top, const YAML::Node& node, const std::string& name, const std::string& weight) {
    const std::optional<std::size_t> metric = MetricOf(top, node, name);
    if (!metric) return;
    if (!metrics_[*metric].is_cost) return top.Fault(node, kObjectiveNoCost, {name});
    const std::optional<double> number = ParseNumber(weight);
    if (!number || !(*number > 0)) return top.Fault(node, kObjectiveWeight, {name, weight});
    for (const Objective& objective : settings_.objectives)
      if (objective.metric == *metric) return top.Fault(node, kObjectiveTwice, {name});
    settings_.objectives.push_back({*metric, *number});
  }

  void ReadObjectives(const StrictMap& top) {
    const YAML::Node node = top.Get("objectives");
    if (!node.IsDefined()) {
      for (std::size_t i = 0; i < metrics_.size() && settings_.objectives.size() < kMostObjectives; ++i)
        if (metrics_[i].is_cost) settings_.objectives.push_back({i, 1});
    } else if (node.IsSequence()) {
      for (const YAML::Node& one : node) AddObjective(top, one, ScalarOf(one), "1");
    } else if (node.IsMap()) {
      for (const auto& entry : node) AddObjective(top, entry.first, ScalarOf(entry.first), ScalarOf(entry.second));
    } else if (node.IsScalar()) {
      AddObjective(top, node, ScalarOf(node), "1");
    }
    if (node.IsDefined() && !node.IsScalar() && node.size() == 0) top.Fault(node, kObjectivesNone);
    if (node.IsDefined() && node.size() > kMostObjectives) top.Fault(node, kObjectivesMany);
    double sum = 0;
    for (const Objective& objective : settings_.objectives) sum += objective.weight;
    for (Objective& objective : settings_.objectives) objective.weight /= sum;
  }

  void ReadLimits(const StrictMap& top) {
    const YAML::Node node = top.Get("limits");
    if (!node.IsDefined()) return;
    if (!node.IsMap()) return top.Fault(node, kLimitsNotMapped);
    std::vector<std::string> names;
    for (const auto& entry : node) names.push_back(ScalarOf(entry.first));
    const StrictMap all = top.Map("limits", {names.begin(), names.end()});
    for (const auto& entry : node) {
      const std::string name = ScalarOf(entry.first);
      const std::optional<std::size_t> metric = MetricOf(all, entry.first, name);
      const StrictMap map(entry.second, "limit '" + name + "'", {"most", "least"}, top.file(), diagnostics_);
      if (!metric || !entry.second.IsMap()) continue;
      MetricLimit limit{.metric = *metric,
                        .most = Bound(map, "most", *metric),
                        .least = Bound(map, "least", *metric),
                        .line = LineOf(entry.second)};
      if (!map.Has("most") && !map.Has("least")) map.Fault(entry.second, kLimitEmpty, {name});
      if (limit.most && limit.least && *limit.most < *limit.least) map.Fault(entry.second, kLimitReversed, {name});
      settings_.limits.push_back(limit);
    }
  }

  std::optional<double> Bound(const StrictMap& map, std::string_view key, std::size_t index) {
    if (!map.Has(key)) return std::nullopt;
    const Metric& metric = metrics_[index];
    const std::optional<Quantity> quantity = ParseQuantity(ScalarOf(map.Get(key)));
    // "30" of a share might be 30 or 3000 %.
    const bool has_unit = quantity && (metric.unit.empty() || !quantity->unit_text.empty());
    if (has_unit && quantity->unit.dimension == metric.dimension) return quantity->si;
    map.FaultOf(key, kLimitUnit,
                {metric.unit.empty() ? "a number without a unit" : "a number with a unit such as " + metric.unit});
    return std::nullopt;
  }

  const Vehicle& vehicle_;
  const std::vector<Metric>& metrics_;
  Diagnostics& diagnostics_;
  SettingsFile settings_;
};

}  // namespace

std::vector<double> SettingsFile::RoadWeights() const {
  std::vector<double> weights;
  for (const ChoiceRoad& road : roads) weights.push_back(road.weight);
  return weights;
}

std::optional<SettingsFile> ReadSettingsText(const std::string& text, const std::filesystem::path& file,
                                             const Vehicle& vehicle, const std::vector<Metric>& metrics,
                                             Diagnostics& diagnostics) {
  Diagnostics own;
  const std::optional<YAML::Node> root = ReadYaml(text, file.string(), own);
  std::optional<SettingsFile> settings;
  if (root) settings = SettingsReader(file, vehicle, metrics, own).Read(*root);
  diagnostics.Add(own);
  if (own.HasErrors()) return std::nullopt;
  return settings;
}

std::optional<SettingsFile> ReadSettingsFile(const std::filesystem::path& file, const Vehicle& vehicle,
                                             const std::vector<Metric>& metrics, Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadTextFile(file, diagnostics);
  if (!text) return std::nullopt;
  return ReadSettingsText(*text, file, vehicle, metrics, diagnostics);
}

}  // namespace fourpost
