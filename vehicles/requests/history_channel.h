#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// A post's height or a sensor's readings, at a fixed rate.
struct HistoryChannel {
  std::string name;
  std::string unit;
  Eigen::VectorXd values;
};

/// Posts, named "post_FL" and the like, then these sensors.
std::vector<HistoryChannel> ChannelsOf(const Vehicle& vehicle, const TimeHistory& history,
                                       const std::vector<std::size_t>& sensors);

/// Size of a channel over its history.
struct Extent {
  double mean = 0;
  double rms = 0;
  double peak = 0;
  double peak_to_peak = 0;
};

/// For at least one sample. A mean that is no more than rounding is zero.
Extent ExtentOf(const Eigen::VectorXd& values);

}  // namespace fourpost
