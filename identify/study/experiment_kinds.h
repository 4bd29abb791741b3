#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "identify/experiments/experiment.h"
#include "identify/experiments/experiment_report.h"
#include "identify/experiments/recording_look.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// A kind of experiment, as studies, reports and `fourpost info` know it.
struct ExperimentKind {
  /// Of a study.
  std::span<const std::string_view> keys;
  /// Nothing where the study has none. Adds every fault to the study's diagnostics.
  std::unique_ptr<Experiment> (*read)(const StrictMap& study);
  const ExperimentReport& (*report)();
  const RecordingViewer* recordings = nullptr;
  /// Whether a study with one of its keys has no other kind.
  bool is_alone = false;
};

/// In the order in which their residuals stand.
std::span<const ExperimentKind> ExperimentKinds();

/// What reports show of each kind.
ExperimentReports AllExperimentReports();

}  // namespace fourpost
