#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/signals/low_pass.h"
#include "analysis/text/diagnostics.h"
#include "identify/experiments/bench/bench_study.h"
#include "identify/study_file/control.h"
#include "identify/study_file/left_out_recording.h"
#include "vehicles/bench/bench_damper.h"
#include "vehicles/bench/bench_motion.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Longer than any damper of a road vehicle.
inline constexpr double kLongestStroke_m = 1;

/// A damper's force while a bench moves it.
struct BenchRecording {
  std::string name;
  double start_s = 0;
  double sample_s = 0;
  /// Of the damper's parameters, while it was recorded.
  ControlSetting setting = {};
  /// What the clamps did, before any filter of the rig.
  BenchMotion motion;
  /// As measured, N.
  std::vector<double> force;
  /// Per sample, whether force or displacement was not measured: in a gap that is bridged. Empty: all were.
  std::vector<char> is_unknown = {};
  /// What was done to it, a sentence each.
  std::vector<std::string> preparations = {};
  /// Through which the force has passed.
  std::optional<LowPass> filter;
  double cutoff_Hz = 0;
  /// Samples that are compared: not those at the ends that the filter disturbs.
  std::size_t first = 0;
  std::size_t end = 0;

  bool IsUnknown(std::size_t sample) const { return !is_unknown.empty() && is_unknown[sample]; }
  double time_s(std::size_t sample) const { return start_s + sample_s * static_cast<double>(sample); }
};

/// The bench recordings of a study in the terms of the vehicle.
struct BenchData {
  /// Place in Vehicle::dampers.
  std::size_t damper = 0;
  std::vector<BenchRecording> fitted;
  std::vector<BenchRecording> validation;
  /// Those of the study's validation that cannot be used.
  std::vector<LeftOutRecording> left_out = {};
};

/// Reads the recordings and looks for what is wrong with them. Adds every fault to `diagnostics`; nothing when there
/// was an error in what is to be fitted. Recordings for validation that have one are left out, with a warning.
std::optional<BenchData> LoadBenchData(const BenchStudy& study, const std::string& study_file, const Vehicle& vehicle,
                                       Diagnostics& diagnostics, const Control& control = {});

/// What the rig would have recorded of this damper [N], at all samples; empty where it cannot move so.
std::vector<double> ModelledForce(const BenchDamper& damper, const BenchRecording& recording,
                                  const std::vector<double>& values);

}  // namespace fourpost
