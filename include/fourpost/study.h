#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fourpost/experiment.h>
#include <fourpost/vehicle.h>

namespace fourpost::api {

/// What a model cannot show of its data, beside their noise, as one standard deviation.
struct ModelError {
  /// Errors of gains and phases of stepped sines.
  double gain_dB = 1;
  double phase_deg = 5;
  /// The least error of a response next to a node, as a share of the largest channel of that unit at that frequency.
  double floor = 0.03;
  /// Error over time, as a share of the standard deviation of each channel.
  double history = 0.02;
  /// Error of forces on a bench, as a share of their standard deviation.
  double bench = 0.05;
  /// Error of mean offsets of struts [m].
  double mean_m = 3e-4;

  bool operator==(const ModelError&) const = default;
};

/// A vehicle, experiments and a search: what a fit is asked for. A study file decides all of this by itself: with one,
/// all members below keep their values and nothing is added, else Write() and Fit() throw Error (code `study-of-file`).
class Study {
 public:
  /// From arrays in memory; experiments are added.
  explicit Study(Vehicle vehicle) : vehicle_(std::move(vehicle)) {}
  /// From a study file.
  explicit Study(std::filesystem::path file) : file_(std::move(file)) {}

  void Add(SteppedSineTest test) { sines_.push_back(std::move(test)); }
  void Add(TimeHistoryTest test) { histories_.push_back(std::move(test)); }
  void Add(BenchTest test) { benches_.push_back(std::move(test)); }

  /// Load of each tyre that was weighed, beside stepped sines or time histories: with tyre forces they set the scale of
  /// masses and rates.
  std::map<std::string, StaticLoad> static_loads;
  /// Parameters to fit; none: all that have a range.
  std::vector<std::string> free;
  /// Fitted frequencies of stepped sines; empty: all.
  std::optional<std::pair<double, double>> band_Hz;
  ModelError model_error;
  std::uint64_t seed = 1;
  int evaluations = 100;
  /// Refinements from distinct good points of the search.
  int starts = 4;

  const std::optional<std::filesystem::path>& file() const { return file_; }
  /// Writes a study from arrays with its vehicle and recordings into a folder, and returns its file; a study file is
  /// returned as it is. Throws Error.
  std::filesystem::path Write(const std::filesystem::path& folder) const;

 private:
  /// What was set beside a study file; empty where nothing was.
  std::string AddedToFile() const;

  std::optional<Vehicle> vehicle_;
  std::optional<std::filesystem::path> file_;
  std::vector<SteppedSineTest> sines_;
  std::vector<TimeHistoryTest> histories_;
  std::vector<BenchTest> benches_;
};

}  // namespace fourpost::api
