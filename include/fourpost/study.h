#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/vehicle.h>

namespace fourpost::api {

// Arrays hold what most tests need. Second harmonics, phases whose deviation differs from that of gains, channels that
// are means or sums of others, delays of channels, and the costs `compromise` and `prediction` need a study file.

/// A measured response with its standard deviation, one value per frequency.
struct MeasuredFrf {
  /// As ChannelResponse::frf.
  Eigen::VectorXcd frf;
  /// Relative to the gain; the phase's is the same in radians.
  double relative_sd = 0.01;
  /// As ChannelResponse::mean; empty where it was not measured. Those of struts are fitted: they alone distinguish bump
  /// from rebound.
  Eigen::VectorXd mean = {};
  /// In place of `relative_sd`, one per frequency; empty: that counts for all.
  Eigen::VectorXd relative_sd_at = {};
  /// Standard deviation of `mean`, in its unit, not without one; empty where it is not known: the study's model error
  /// of means counts alone.
  Eigen::VectorXd mean_sd = {};
};

/// A stepped sine on posts.
struct SteppedSineTest {
  std::string name;
  /// As in SteppedSine.
  std::string posts = "heave";
  std::vector<double> frequency_Hz;
  /// Amplitude of the reference post [m]: one per frequency, or one for all.
  std::vector<double> amplitude_m;
  /// Responses by the name of their sensor. A sensor of one test is fitted in all tests of a study, so measure the same
  /// ones in each.
  std::map<std::string, MeasuredFrf> channels;
  /// For validation: left out of the fit and predicted after it.
  bool is_validation = false;
};

struct LowPass {
  int order = 4;
  double cutoff_Hz = 0;
};

/// A recording over time on moving posts; all samples at k / rate_Hz.
struct TimeHistoryTest {
  std::string name;
  double rate_Hz = 0;
  /// Heights by the name of their post [m], and readings by that of their sensor, in its SI unit.
  std::map<std::string, Eigen::VectorXd> posts;
  std::map<std::string, Eigen::VectorXd> channels;
  /// Standard deviation of a sensor's reading at rest, in its SI unit; zero of those that are not named.
  std::map<std::string, double> noise = {};
  /// The causal Butterworth low-pass through which all channels and posts were recorded.
  std::optional<LowPass> filter = {};
  /// For validation: left out of the fit and predicted after it.
  bool is_validation = false;
};

/// A damper on its bench.
struct BenchTest {
  double rate_Hz = 0;
  /// Extension of the damper [m], and its tension [N].
  Eigen::VectorXd displacement;
  Eigen::VectorXd force;
  /// For validation: left out of the fit and predicted after it.
  bool is_validation = false;
};

/// The load on a tyre of the resting vehicle.
struct StaticLoad {
  double load_N = 0;
  double sd_N = 0;
};

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
