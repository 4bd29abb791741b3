#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/bench_study.h"
#include "identify/channel_source.h"
#include "identify/history_study.h"
#include "identify/robust_loss.h"

namespace fourpost {

/// A recording and the motion of the posts that made it.
struct StudyRecording {
  std::string name;
  std::filesystem::path file;
  /// Post of the vehicle, and how far it moves relative to the reference: -1 for opposite phase. Empty with a pattern.
  std::vector<std::pair<std::string, double>> posts;
  /// One of kPostPatterns, in place of `posts`.
  std::optional<std::string> pattern;
  int line = 0;
};

/// Parts of the misfit that are the model's fault, not the rig's: added to the measured standard deviations, so that a
/// model too simple for the data is not pulled by noise-free detail it cannot show.
struct ModelError {
  double gain_dB = 1;
  double phase_rad = 0.087266462599716474;  // 5 degrees
  double mean_m = 0.3e-3;
  /// Of amplitudes of the struts' second harmonics; zero: they are not fitted.
  double second_harmonic_m = 0;
  /// Of time histories: share of a channel's deviation.
  double history = 0.02;
  /// Of responses, as a share of the loudest channel of that unit at that frequency: next to a node, where a channel
  /// all but rests, a model that has the node elsewhere would else be wrong by many times the gain.
  double floor = 0.03;
};

/// Settings of the search and the refinement that a study may change.
struct StudySearch {
  std::uint64_t seed = 1;
  /// One of kMethodNames or of the study's own; of one that refines, what it does before.
  std::string method = "dvhde";
  int method_line = 0;
  /// Empty: 100 of a fit, which refines after them; 3000 of a comparison.
  std::optional<std::int64_t> evaluations;
  /// Empty: the method's own.
  std::optional<int> population;
  int starts = 4;
  /// Of a fit: the thesis's appendix A.
  int generations = 150;
  /// Generations without a better cost after which it ends; 0: never.
  int stagnation = 0;
  /// Wall time after which it ends: then results depend on the machine.
  double time_s = std::numeric_limits<double>::infinity();
  /// What one evaluation may take: some thousand times what it takes as a rule, so that only one that hangs ends by it,
  /// however busy the machine is.
  double deadline_s = 10;
};

/// The refinement of a fit.
struct StudyRefine {
  LossKind loss = LossKind::kNone;
  /// In standard deviations; empty: UsualScale().
  std::optional<double> scale;
};

/// A setting of a method, as written.
struct StudySetting {
  std::string key;
  std::string value;
  int line = 0;
};

/// A search method to compare: a preset with some settings changed.
struct StudyMethod {
  std::string name;
  /// As in kMethodNames.
  std::string preset;
  std::vector<StudySetting> settings;
  int line = 0;
};

/// A study as its YAML file tells it; paths are resolved against the file's folder.
struct Study {
  std::filesystem::path file;
  /// As read.
  std::string text;
  /// One of kTestProblems in place of a vehicle and its recordings.
  std::optional<std::string> problem;
  int problem_line = 0;
  std::filesystem::path vehicle;
  int vehicle_line = 0;
  std::vector<StudyRecording> recordings;
  std::vector<StudyHistory> histories;
  HistoryCost history_cost = HistoryCost::kWhitened;
  /// Sensor of the vehicle, and what was measured for it.
  std::vector<std::pair<std::string, ChannelSource>> channels;
  std::optional<std::filesystem::path> static_loads_file;
  /// Of a damper, in place of those of a vehicle.
  std::optional<BenchStudy> bench;
  /// Tyre of the vehicle, and the measured loads under it.
  std::vector<std::pair<std::string, ChannelSource>> static_loads;
  /// Parameters of the vehicle to fit; empty: every one that has a range.
  std::vector<std::string> free;
  int free_line = 0;
  double band_lower_Hz = 0;
  double band_upper_Hz = 0;
  int band_line = 0;
  ModelError model_error;
  StudySearch search;
  StudyRefine refine;
  /// Cost at which a search has solved it; for comparisons.
  std::optional<double> target_cost;
  std::vector<StudyMethod> methods;
};

/// Reads a study. Adds every fault to `diagnostics` with file and line; nothing when there was an error.
std::optional<Study> ReadStudy(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace fourpost
