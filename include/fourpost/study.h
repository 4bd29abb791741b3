#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fourpost/experiment.h>
#include <fourpost/vehicle.h>

namespace fourpost::api {

/// What a model cannot show of its data, beside their noise, as one standard deviation.
struct ModelError {
  /// Of stepped sines.
  double gain_dB = 1;
  double phase_deg = 5;
  /// Of a response, as a share of the channel's largest.
  double floor = 0.03;
  /// Of time histories, as a share of each channel's standard deviation.
  double history = 0.02;
  /// Of benches, as a share of the force's standard deviation.
  double bench = 0.05;
};

/// A vehicle, experiments and a search: what a fit is asked for.
class Study {
 public:
  /// Of arrays in memory; experiments are added.
  explicit Study(Vehicle vehicle) : vehicle_(std::move(vehicle)) {}
  /// A study file; its settings are the file's, and nothing can be added.
  explicit Study(std::filesystem::path file) : file_(std::move(file)) {}

  void Add(SteppedSineTest test) { sines_.push_back(std::move(test)); }
  void Add(TimeHistoryTest test) { histories_.push_back(std::move(test)); }
  void Add(BenchTest test) { benches_.push_back(std::move(test)); }

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
  /// Writes the study of arrays with its vehicle and recordings into a folder, and returns its file. Throws Error.
  std::filesystem::path Write(const std::filesystem::path& folder) const;

 private:
  std::optional<Vehicle> vehicle_;
  std::optional<std::filesystem::path> file_;
  std::vector<SteppedSineTest> sines_;
  std::vector<TimeHistoryTest> histories_;
  std::vector<BenchTest> benches_;
};

}  // namespace fourpost::api
