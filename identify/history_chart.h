#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// A post's height or a sensor's readings, at a fixed rate.
struct HistoryChannel {
  std::string name;
  std::string unit;
  Eigen::VectorXd values;
};

/// A time history as an SVG document: one row for each channel, on the left all of it, by the least and the greatest
/// value of each of several hundred slices, on the right the second about its peak. Throws std::invalid_argument
/// without a channel, and for channels of fewer than two samples.
std::string HistorySvg(const std::string& title, double start_s, double rate_Hz,
                       const std::vector<HistoryChannel>& channels);

}  // namespace fourpost
