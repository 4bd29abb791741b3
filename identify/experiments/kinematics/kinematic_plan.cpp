#include "identify/experiments/kinematics/kinematic_plan.h"

#include <algorithm>

#include "analysis/text/nearest.h"
#include "identify/experiments/kinematics/findings.h"
#include "identify/study_file/channel_source_reader.h"
#include "identify/study_file/findings.h"

namespace fourpost {
namespace {

std::vector<std::string> QuantityNames() {
  std::vector<std::string> names;
  for (const KinematicQuantity& quantity : KinematicQuantities()) names.emplace_back(quantity.name);
  return names;
}

class PlanReader {
 public:
  PlanReader(const StrictMap& study, const YAML::Node& entry)
      : study_(study),
        map_(entry, "a table of 'kinematics'",
             {"name", "file", "axle", "motion", "case", "travel", "force", "torque", "channels", "noise", "offset",
              "use"},
             study.file(), study.diagnostics()) {}

  KinematicPlan Read() {
    plan_.study = study_.file();
    plan_.line = map_.line();
    map_.Require("file");
    if (const auto file = map_.Text("file")) plan_.file = study_.Resolve(*file);
    plan_.name = map_.Text("name").value_or(plan_.file.stem().string());
    plan_.axle = map_.Text("axle").value_or("");
    plan_.motion = map_.Text("motion").value_or("");
    ReadWords();
    ReadPosition();
    if (map_.Has("channels"))
      plan_.channels = ReadChannelSources(map_.Get("channels"), "'channels'", "quantities", ChannelKind::kCurve,
                                          map_.file(), map_.diagnostics());
    if (const YAML::Node noise = map_.Require("noise"); noise.IsDefined()) ReadNoise(noise);
    if (map_.Has("offset")) ReadOffset(map_.Get("offset"));
    return plan_;
  }

 private:
  void ReadPosition() {
    std::string first;
    for (const std::string key : {"travel", "force", "torque"}) {
      if (!map_.Has(key)) continue;
      if (!first.empty()) {
        map_.FaultOf(key, kKinematicPositionTwice, {first});
        continue;
      }
      first = key;
      plan_.position =
          ReadSourceChannel(map_.Get(key), "'" + key + "'", ChannelKind::kCurve, map_.file(), map_.diagnostics());
    }
  }

  void ReadWords() {
    if (const auto use = map_.Text("use")) {
      plan_.is_validation = *use == "validation";
      if (*use != "fit" && *use != "validation") map_.FaultOf("use", kKinematicUse);
    }
    if (const auto load_case = map_.Text("case")) {
      plan_.is_opposed = *load_case == "opposed";
      if (*load_case != "opposed" && *load_case != "together") map_.FaultOf("case", kKinematicCase);
    }
  }

  void ReadNoise(const YAML::Node& node) {
    constexpr double kMost = 1e12;
    if (!node.IsMap() || node.size() == 0) return map_.Fault(node, kKinematicNoiseNotMapped);
    std::vector<std::string> keys;
    for (const auto& entry : node) keys.push_back(entry.first.as<std::string>());
    const StrictMap noise(node, "'noise'", {keys.begin(), keys.end()}, map_.file(), map_.diagnostics());
    for (const std::string& key : keys) {
      const KinematicQuantity* quantity = FindKinematicQuantity(key);
      if (!quantity) {
        const std::vector<std::string> legal = QuantityNames();
        noise.Fault(node[key], kKinematicQuantityUnknown, {key, DidYouMeanOrAll(key, legal)});
        continue;
      }
      const std::string text = noise.Text(key).value_or("");
      const bool is_share = text.ends_with('%');
      // Motion ratios are numbers alone.
      const std::optional<double> sd = quantity->unit.empty() && !is_share
                                           ? noise.Number(key, 0, kMost)
                                           : noise.Quantity(key, quantity->dimension, 0);
      if (sd && *sd == 0) noise.FaultOf(key, kKeyNotPositive);
      if (quantity->unit == "deg" && is_share) noise.Fault(node[key], kKinematicAngleUnit, {key, text});
      plan_.noise.push_back({quantity, sd.value_or(1)});
    }
  }

  void ReadOffset(const YAML::Node& node) {
    const bool is_all = node.IsScalar() && node.Scalar() == "free";
    if (!is_all && !node.IsSequence()) return map_.Fault(node, kKinematicOffset);
    for (KinematicPlan::Noise& noise : plan_.noise) noise.has_free_offset = is_all;
    if (is_all) return;
    for (const YAML::Node& entry : node) {
      const auto name = entry.as<std::string>("");
      const auto found = std::find_if(plan_.noise.begin(), plan_.noise.end(),
                                      [&](const KinematicPlan::Noise& noise) { return noise.quantity->name == name; });
      if (found == plan_.noise.end()) map_.Fault(entry, kKinematicOffsetOfNone, {name});
      else found->has_free_offset = true;
    }
  }

  const StrictMap& study_;
  StrictMap map_;
  KinematicPlan plan_;
};

}  // namespace

std::vector<KinematicPlan> ReadKinematicPlans(const StrictMap& study) {
  std::vector<KinematicPlan> plans;
  const YAML::Node list = study.Get("kinematics");
  if (!list.IsSequence() || list.size() == 0) {
    study.FaultOf("kinematics", kKinematicsEmpty);
    return plans;
  }
  for (const YAML::Node& entry : list) {
    plans.push_back(PlanReader(study, entry).Read());
    const auto is_same = [&](const KinematicPlan& one) { return one.name == plans.back().name; };
    if (std::count_if(plans.begin(), plans.end(), is_same) > 1)
      study.Fault(entry, kKinematicNameTwice, {plans.back().name});
  }
  if (std::all_of(plans.begin(), plans.end(), [](const KinematicPlan& plan) { return plan.is_validation; }))
    study.FaultOf("kinematics", kKinematicsNotFitted);
  return plans;
}

}  // namespace fourpost
