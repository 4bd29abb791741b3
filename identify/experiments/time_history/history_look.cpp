#include "identify/experiments/time_history/history_look.h"

#include "analysis/files/recording_layout.h"

namespace fourpost {
namespace {

/// Any that has rows over time, or is to have them.
bool IsOverTime(const RecordedTable& table) { return !IsSteppedSine(table); }

std::optional<RecordingLook> LookAt(const std::filesystem::path& file, const RecordedTable& table, Diagnostics&) {
  const RecordingSummary summary = Summarise(table);
  return LookOverTime(file, table, summary, ChannelsInKnownUnits(table, summary), {});
}

}  // namespace

const RecordingViewer kHistoryViewer{.takes = &IsOverTime, .look = &LookAt};

}  // namespace fourpost
