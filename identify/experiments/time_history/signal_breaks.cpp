#include "identify/experiments/time_history/signal_breaks.h"

#include <algorithm>
#include <limits>
#include <set>
#include <span>

#include "analysis/files/sample_times.h"
#include "analysis/signals/jumps.h"
#include "analysis/signals/spikes.h"
#include "analysis/text/counted.h"
#include "analysis/text/short_number.h"
#include "analysis/text/units.h"
#include "identify/experiments/time_history/findings.h"

namespace fourpost {
namespace {

std::span<const double> ValuesOf(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// Of the window, of posts.
std::set<std::size_t> JumpsOfPosts(const MeasuredHistory& history) {
  std::set<std::size_t> jumps;
  for (const std::vector<double>& heights : history.heights) {
    const auto window =
        std::span(heights).subspan(static_cast<std::size_t>(history.first), static_cast<std::size_t>(history.count));
    for (const std::size_t jump : Jumps(window)) jumps.insert(jump);
  }
  return jumps;
}

std::vector<std::size_t> Outliers(std::span<const double> signal) {
  std::vector<std::size_t> spikes = Spikes(signal);
  if (spikes.empty()) return spikes;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    if (std::binary_search(spikes.begin(), spikes.end(), k)) continue;
    least = std::min(least, signal[k]);
    most = std::max(most, signal[k]);
  }
  std::erase_if(spikes,
                [&](std::size_t k) { return signal[k] < most + (most - least) && signal[k] > least - (most - least); });
  return spikes;
}

}  // namespace

void ReportSpikes(const MeasuredHistory& history, const std::string& study_file, Diagnostics& diagnostics) {
  for (const MeasuredSignal& signal : history.signals) {
    const std::vector<std::size_t> spikes = Outliers(ValuesOf(signal.values));
    if (spikes.empty()) continue;
    const auto first = static_cast<Eigen::Index>(spikes.front());
    diagnostics.Report(
        kChannelSpiked, {study_file, signal.source.line},
        {signal.name, history.name, Counted(spikes.size(), "sample"),
         ShortNumber(signal.values[first], 3) + " " + signal.unit, SecondsText(history.TimeAt(first))});
  }
}

std::vector<BridgedGap> ClosedUpTimes(const MeasuredHistory& history) {
  const std::set<std::size_t> of_posts = JumpsOfPosts(history);
  std::set<std::size_t> common;
  for (const MeasuredSignal& signal : history.signals) {
    if (of_posts.empty() || ParseUnit(signal.unit)->dimension != kLength) continue;
    for (const std::size_t jump : Jumps(ValuesOf(signal.values)))
      if (of_posts.count(jump) > 0) common.insert(jump);
  }
  std::vector<BridgedGap> gaps;
  for (const std::size_t jump : common)
    gaps.push_back(
        {history.TimeAt(static_cast<Eigen::Index>(jump)), history.TimeAt(static_cast<Eigen::Index>(jump) + 1)});
  return gaps;
}

}  // namespace fourpost
