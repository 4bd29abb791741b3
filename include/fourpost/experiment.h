#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

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

}  // namespace fourpost::api
