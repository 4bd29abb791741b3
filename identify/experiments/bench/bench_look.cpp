#include "identify/experiments/bench/bench_look.h"

#include "analysis/files/recording_layout.h"
#include "identify/experiments/bench/bench_data.h"
#include "vehicles/bench/recording_check.h"

namespace fourpost {
namespace {

/// Of a table of nothing but a displacement and a force these two, in this order; else none.
std::vector<RecordedChannel> BenchChannels(const RecordedTable& table, const RecordingSummary& summary) {
  const std::vector<RecordedChannel> channels = ChannelsInKnownUnits(table, summary);
  std::vector<RecordedChannel> bench;
  for (const Dimension& dimension : {kLength, kForce})
    for (const RecordedChannel& channel : channels)
      if (channel.dimension == dimension) bench.push_back(channel);
  return channels.size() == 2 && bench.size() == 2 && bench[0].dimension != bench[1].dimension
             ? bench
             : std::vector<RecordedChannel>();
}

bool IsOfBench(const RecordedTable& table) {
  // A bench has few channels, and many would take long to look at.
  constexpr std::size_t kMost = 16;
  return table.names().size() <= kMost && !IsSteppedSine(table) && !BenchChannels(table, Summarise(table)).empty();
}

/// By the check of bench recordings.
std::vector<std::string> BenchRefusals(const TimeRecording& recording, const std::string& file) {
  Diagnostics findings;
  CheckBenchRecording(recording, kLongestStroke_m, file, findings);
  std::vector<std::string> refusals;
  for (const Diagnostic& finding : findings.items())
    if (finding.severity == Severity::kError)
      refusals.push_back("as a recording of a damper bench: " + RefusalText(finding));
  return refusals;
}

std::optional<RecordingLook> LookAt(const std::filesystem::path& file, const RecordedTable& table, Diagnostics&) {
  const RecordingSummary summary = Summarise(table);
  return LookOverTime(file, table, summary, BenchChannels(table, summary),
                      [&](const TimeRecording& recording) { return BenchRefusals(recording, file.string()); });
}

}  // namespace

const RecordingViewer kBenchViewer{.takes = &IsOfBench, .look = &LookAt};

}  // namespace fourpost
