#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/bench_data.h"
#include "identify/fitted_files.h"
#include "identify/four_post_data.h"
#include "identify/history_data.h"
#include "identify/history_residuals.h"
#include "identify/left_out_recording.h"
#include "identify/study.h"
#include "identify/vehicle_objective.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A study with everything it names: vehicle and recordings.
struct LoadedStudy {
  Study study;
  Vehicle vehicle;
  FourPostData data;
  /// Parameters to fit, as indices into Vehicle::parameters.
  std::vector<std::size_t> free;
  /// Recordings over time.
  std::vector<MeasuredHistory> histories = {};
  /// Those that the fit does not see.
  std::vector<MeasuredHistory> validation = {};
  /// Those kept for validation, over time or of a bench, that cannot be used.
  std::vector<LeftOutRecording> left_out = {};
  std::optional<BenchData> bench = {};
  /// As they were read: a file may change while a fit runs.
  std::vector<FileDigest> fitted_files = {};
  std::vector<FileDigest> validation_files = {};
  /// Of a cost by prediction; one per history once EstimateNoise() found it.
  std::vector<KalmanNoise> kalman_noise = {};

  /// Of a cost by prediction: the noise under which the file's values are likeliest, to be held from then on. Throws
  /// FaultyInput where a run of the filter takes longer than the study's deadline.
  void EstimateNoise(const std::function<void(int runs)>& progress = {});

  HistoryResiduals::Options HistoryOptions() const;

  /// Whether the cost weighs by noise, so that a fit has standard deviations: the compromise cost has none.
  bool TellsDeviations() const;

  /// The misfit over the study's band. Throws FaultyInput when the vehicle cannot be assembled or held.
  VehicleObjective MakeObjective() const;
};

/// Reads a study, its vehicle and its recordings. Adds every fault of all of them to `diagnostics`; nothing when there
/// was an error. Recordings for validation that have a fault are left out, with a warning.
std::optional<LoadedStudy> LoadStudy(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace fourpost
