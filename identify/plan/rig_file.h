#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/study_file/model_error.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/amplitude_law.h"

namespace fourpost {

/// A stepped sine that a rig can make.
struct RigRun {
  std::string name;
  /// Of each post, see Excitation.
  std::vector<double> shape;
  std::vector<double> frequency_Hz;
  AmplitudeLaw amplitude;
  /// Whether it belongs to what is measured without a plan.
  bool is_usual = true;
};

/// A number that can be measured without the rig: a mass on scales, a rate on a bench.
struct DirectMeasurement {
  std::string name;
  std::string parameter;
  /// SI.
  double sd = 0;
  double time_s = 0;
};

/// What is wanted of a parameter.
struct WantedDeviation {
  std::string parameter;
  /// SI.
  double sd = 0;
};

/// What a rig can measure, how well, and in which time.
struct RigFile {
  std::filesystem::path file;
  std::vector<RigRun> runs;
  std::vector<DirectMeasurement> measurements;
  std::vector<WantedDeviation> wanted;
  /// By sensor: standard deviation of an amplitude from repeat to repeat, SI; NaN: not stated.
  std::vector<double> noise;
  /// By sensor: whether it is read.
  std::vector<bool> is_read;
  bool states_sensors = false;
  /// What repeats do not average out, as in a study.
  ModelError model_error;
  bool states_model_error = false;
  /// Cycles of each frequency that are measured, after as many as the car needs to settle.
  int cycles = 10;
  int most_repeats = 10;
  double time_s = 3600;
  /// Before each repeat of a run.
  double setup_s = 120;

  /// Of a frequency: in which the car settles, and in which it is measured [s].
  double SettlingOf(double frequency_Hz) const;
  double MeasuringOf(double frequency_Hz) const;
  /// Of one repeat, set-up included.
  double TimeOf(const RigRun& run) const;
};

/// What is assumed of a rig without a file: heave, pitch and roll, as far as the posts can make them, in three parts of
/// 0.5 to 30 Hz, with the usual amplitudes and with a third of them.
RigFile UsualRig(const Vehicle& vehicle);

/// Reads the text of a rig's file. `determined`: places of the parameters to determine. Adds every fault with file and
/// line; nothing when there was an error.
std::optional<RigFile> ReadRigText(const std::string& text, const std::filesystem::path& file, const Vehicle& vehicle,
                                   const std::vector<std::size_t>& determined, Diagnostics& diagnostics);

}  // namespace fourpost
