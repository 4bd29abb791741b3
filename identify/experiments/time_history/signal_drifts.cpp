#include "identify/experiments/time_history/signal_drifts.h"

#include <algorithm>
#include <optional>
#include <span>

#include "analysis/signals/slow_drift.h"
#include "analysis/text/short_number.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/study_file/channel_source_text.h"

namespace fourpost {
namespace {

bool HasDriftingPost(const MeasuredHistory& history) {
  return std::any_of(history.heights.begin(), history.heights.end(), [&](const std::vector<double>& heights) {
    return SlowDrift(std::span(heights).subspan(static_cast<std::size_t>(history.first),
                                                static_cast<std::size_t>(history.count)))
        .has_value();
  });
}

std::string WithoutTrend(ChannelSource source) {
  for (SourceChannel& channel : source.channels) channel.has_trend = true;
  return SourceText(source);
}

}  // namespace

void ReportDrifts(const MeasuredHistory& history, const std::string& study_file, Diagnostics& diagnostics) {
  if (history.release || HasDriftingPost(history)) return;
  for (const MeasuredSignal& signal : history.signals) {
    const std::span<const double> values(signal.values.data(), static_cast<std::size_t>(signal.values.size()));
    const std::optional<double> drift = SlowDrift(values);
    if (!drift) continue;
    const double duration_s = static_cast<double>(history.count) / history.rate_Hz;
    diagnostics.Report(kChannelDrifts, {study_file, signal.source.line},
                       {signal.name, history.name, ShortNumber(*drift, 2) + " " + signal.unit,
                        ShortNumber(duration_s, 3) + " s", signal.name + ": " + WithoutTrend(signal.source)});
  }
}

}  // namespace fourpost
