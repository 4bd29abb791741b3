#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/files/recording_window.h"
#include "analysis/files/time_recording.h"
#include "identify/study_file/channel_source.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// The low-pass of a rig's amplifiers, a Butterworth filter.
struct RigFilter {
  int order = 4;
  double cutoff_Hz = 30;
};

/// What the file of a study states under 'bench': recordings of a damper on its bench. Paths are resolved.
struct BenchStudy {
  struct Recording {
    std::string name;
    std::filesystem::path file;
    /// In place of the bench's, such as one of the other sign.
    std::optional<SourceChannel> displacement = {};
    std::optional<SourceChannel> force = {};
    std::optional<SourceChannel> time = {};
    /// What is done to its times; files beside it are resolved.
    TimePreparation preparation = {};
    /// The rest is cut off before anything is looked at.
    RecordingWindow window = {};
    /// Of a control that parameters follow.
    std::optional<double> setting = {};
    int line = 0;
  };
  /// Of the vehicle; its only one when empty.
  std::optional<std::string> damper;
  int line = 0;
  /// Columns of the recordings.
  SourceChannel displacement = "displacement";
  SourceChannel force = "force";
  /// One of the usual names when empty.
  std::optional<SourceChannel> time;
  /// Through which both channels have passed on the rig.
  std::optional<RigFilter> rig_filter;
  /// What the model may miss, as a share of the measured force's standard deviation.
  double model_error = 0.05;
  std::vector<Recording> recordings;
  /// Those that the fit does not see.
  std::vector<Recording> validation;
};

BenchStudy ReadBenchStudy(const YAML::Node& node, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
