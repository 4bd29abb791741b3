#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/response/excitation.h"

namespace fourpost {

/// By what a sensor's measured response differs from the modelled one, as a FrequencyResponse has them; NaN where
/// nothing was measured.
struct ReadingDifference {
  /// Index into Vehicle::sensors.
  std::size_t sensor = 0;
  std::vector<std::complex<double>> difference;
};

/// Steady motion of the posts that was recorded.
struct RecordedMotion {
  std::string name;
  Excitation excitation;
  std::vector<ReadingDifference> differences;
};

/// How posts and vehicle moved, from time to time.
struct HistoryMotion {
  double start_s = 0;
  double rate_Hz = 0;
  /// Frames x posts: heights [m].
  Eigen::MatrixXd posts;
  /// Frames x independent coordinates of the condensed model, from the design pose.
  Eigen::MatrixXd coordinates;
};

/// A recording, and how the posts and the fitted vehicle moved in it.
struct RecordedHistory {
  std::string name;
  HistoryMotion motion;
};

/// What a report can show of a vehicle on its posts.
struct RecordedMotions {
  std::vector<RecordedMotion> steady;
  std::vector<RecordedHistory> over_time;
};

}  // namespace fourpost
