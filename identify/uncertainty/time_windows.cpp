#include "identify/uncertainty/time_windows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "analysis/text/short_number.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr std::size_t kWindows = 5;

/// Series of one record, by its number.
std::map<int, std::vector<const ResidualSeries*>> RecordsOf(const std::vector<ResidualSeries>& series) {
  std::map<int, std::vector<const ResidualSeries*>> records;
  for (const ResidualSeries& one : series)
    if (one.is_over_time) records[one.record].push_back(&one);
  return records;
}

/// First sample of each window, and one behind the last.
std::vector<Index> CutsOf(const std::vector<const ResidualSeries*>& channels, const Eigen::VectorXd& leverage,
                          std::size_t windows) {
  const Index count = channels.front()->count;
  Eigen::VectorXd by_sample = Eigen::VectorXd::Zero(count);
  for (const ResidualSeries* channel : channels)
    for (Index k = 0; k < std::min(count, channel->count); ++k)
      by_sample[k] += leverage[channel->first + k * channel->step];
  const double each = by_sample.sum() / static_cast<double>(windows);
  std::vector<Index> cuts = {0};
  double sum = 0;
  for (Index k = 0; k < count && sum < each * static_cast<double>(windows - 1); ++k) {
    const double before = sum;
    sum += by_sample[k];
    if (std::floor(sum / each) > std::floor(before / each)) cuts.push_back(k + 1);
  }
  if (cuts.back() < count) cuts.push_back(count);
  return cuts;
}

std::string WindowName(const ResidualSeries& series, Index first, Index end) {
  const auto time = [&](Index k) { return ShortNumber(series.start_s + static_cast<double>(k) * series.interval_s); };
  return time(first) + " to " + time(end) + " s";
}

}  // namespace

ResidualPartition WindowsOfTime(const ResidualStructure& structure, const Eigen::VectorXd& leverage) {
  const ResidualPartition& records = structure.recordings;
  const auto over_time = RecordsOf(structure.series);
  std::vector<std::string> names;
  for (const std::size_t cluster : records.cluster_of) names.push_back(records.clusters[cluster]);
  const std::size_t windows = over_time.empty() ? 1 : (kWindows + over_time.size() - 1) / over_time.size();
  for (const auto& [number, channels] : over_time) {
    const std::vector<Index> cuts = CutsOf(channels, leverage, windows);
    for (const ResidualSeries* channel : channels)
      for (std::size_t window = 0; window + 1 < cuts.size() && windows > 1; ++window) {
        const std::string times = WindowName(*channel, cuts[window], cuts[window + 1]);
        for (Index k = cuts[window]; k < std::min(cuts[window + 1], channel->count); ++k) {
          std::string& name = names[static_cast<std::size_t>(channel->first + k * channel->step)];
          name = over_time.size() == 1 ? times : name + ", " + times;
        }
      }
  }
  ResidualPartition parted = {"windows of time", {}, {}};
  for (const std::string& name : names) parted.Add(name, 1);
  return parted;
}

}  // namespace fourpost
