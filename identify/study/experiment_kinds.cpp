#include "identify/study/experiment_kinds.h"

#include <algorithm>
#include <array>
#include <string>

#include "identify/experiments/bench/bench_look.h"
#include "identify/experiments/bench/bench_report.h"
#include "identify/experiments/bench/damper_bench.h"
#include "identify/experiments/four_post/four_post.h"
#include "identify/experiments/four_post/four_post_report.h"
#include "identify/experiments/four_post/stepped_sine_look.h"
#include "identify/experiments/kinematics/kinematic_look.h"
#include "identify/experiments/kinematics/kinematic_report.h"
#include "identify/experiments/kinematics/kinematics_rig.h"
#include "identify/experiments/static_loads/static_load_look.h"
#include "identify/experiments/static_loads/static_load_report.h"
#include "identify/experiments/static_loads/static_loads.h"
#include "identify/experiments/time_history/history_look.h"
#include "identify/experiments/time_history/history_report.h"
#include "identify/experiments/time_history/time_histories.h"

namespace fourpost {
namespace {

/// Stepped sines are what a study is asked for that names no other recordings to fit.
std::unique_ptr<Experiment> ReadFourPost(const StrictMap& study) {
  const auto is_fitted = [](const YAML::Node& history) {
    return !history.IsMap() || !history["use"].IsDefined() || history["use"].as<std::string>("") != "validation";
  };
  const YAML::Node histories = study.Get("histories");
  // A missing node throws when it is asked for its type.
  const bool has_other =
      histories.IsDefined() && histories.IsSequence() && std::any_of(histories.begin(), histories.end(), is_fitted);
  const bool is_asked = !has_other && !study.Has("kinematics");
  return study.Has("recordings") || is_asked ? FourPost::Read(study) : nullptr;
}

const std::array<ExperimentKind, 5> kKinds{{
    {.keys = FourPost::kKeys, .read = &ReadFourPost, .report = &FourPostReport, .recordings = &kSteppedSineViewer},
    {.keys = TimeHistories::kKeys,
     .read = &TimeHistories::Read,
     .report = &HistoryReport,
     .recordings = &kHistoryViewer},
    {.keys = StaticLoadTest::kKeys,
     .read = &StaticLoadTest::Read,
     .report = &StaticLoadReport,
     .recordings = &kStaticLoadViewer},
    {.keys = KinematicsRig::kKeys,
     .read = &KinematicsRig::Read,
     .report = &KinematicReport,
     .recordings = &kKinematicViewer},
    {.keys = DamperBench::kKeys,
     .read = &DamperBench::Read,
     .report = &BenchReport,
     .recordings = &kBenchViewer,
     .is_alone = true},
}};

}  // namespace

std::span<const ExperimentKind> ExperimentKinds() { return kKinds; }

ExperimentReports AllExperimentReports() {
  static const std::array<const ExperimentReport*, kKinds.size()> reports = [] {
    std::array<const ExperimentReport*, kKinds.size()> list{};
    std::transform(kKinds.begin(), kKinds.end(), list.begin(),
                   [](const ExperimentKind& kind) { return &kind.report(); });
    return list;
  }();
  return reports;
}

}  // namespace fourpost
