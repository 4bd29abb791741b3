#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fourpost::api {

/// A measured response with its standard deviation, one value per frequency.
struct MeasuredFrf {
  /// As ChannelResponse::frf.
  Eigen::VectorXcd frf;
  /// Relative to the gain; the phase's is the same in radians.
  double relative_sd = 0.01;
};

/// A stepped sine on posts.
struct SteppedSineTest {
  std::string name;
  /// As in SteppedSine.
  std::string posts = "heave";
  std::vector<double> frequency_Hz;
  /// One per frequency, or one for all [m].
  std::vector<double> amplitude_m;
  /// By sensor of the vehicle.
  /// A sensor of one test is fitted in all tests of a study that have it.
  std::map<std::string, MeasuredFrf> channels;
};

/// A recording over time on moving posts; all samples at k / rate_Hz.
struct TimeHistoryTest {
  std::string name;
  double rate_Hz = 0;
  /// By post [m], and by sensor of the vehicle, in its SI unit.
  std::map<std::string, Eigen::VectorXd> posts;
  std::map<std::string, Eigen::VectorXd> channels;
  /// For validation: left out of the fit and predicted after it.
  bool is_validation = false;
};

/// A damper on its bench.
struct BenchTest {
  double rate_Hz = 0;
  /// Extension of the damper [m], and its tension [N].
  Eigen::VectorXd displacement;
  Eigen::VectorXd force;
  bool is_validation = false;
};

}  // namespace fourpost::api
