#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/experiment.h"
#include "identify/refine/robust_loss.h"
#include "identify/study_file/calibration.h"
#include "identify/study_file/control.h"

namespace fourpost {

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

/// A value of a parameter, as written: "40 kN/m".
struct StudyStart {
  std::string parameter;
  std::string value;
  int line = 0;
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

/// A vehicle, experiments and a search, as a YAML file describes them; paths are resolved against the file's folder.
struct Study {
  std::filesystem::path file;
  /// As read.
  std::string text;
  /// One of kTestProblems in place of a vehicle and its experiments.
  std::optional<std::string> problem;
  int problem_line = 0;
  std::filesystem::path vehicle;
  int vehicle_line = 0;
  Experiments experiments;
  /// Parameters of the vehicle to fit; empty: every one that has a range, but those held.
  std::vector<std::string> free;
  std::vector<std::string> held;
  int free_line = 0;
  /// Values of parameters in place of the vehicle file's.
  std::vector<StudyStart> start;
  /// Which parameters follow the recordings' settings.
  StudyControl control;
  /// What is not exactly known of the instruments.
  std::vector<Calibration> calibrations;
  StudySearch search;
  StudyRefine refine;
  /// Cost at which a search has solved it; for comparisons.
  std::optional<double> target_cost;
  std::vector<StudyMethod> methods;
};

/// Reads a study. Adds every fault to `diagnostics` with file and line; nothing when there was an error.
std::optional<Study> ReadStudy(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The same for a text, the content of `file`. Findings name `file`, and paths are resolved against its folder.
std::optional<Study> ReadStudyText(const std::string& text, const std::filesystem::path& file,
                                   Diagnostics& diagnostics);

}  // namespace fourpost
