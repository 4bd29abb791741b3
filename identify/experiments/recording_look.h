#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/files/recorded_table.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/time_recording.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// What `fourpost info` says of a recording: for the terminal, and as JSON.
struct RecordingLook {
  std::string text;
  nlohmann::ordered_json json;
};

/// How a kind of experiment looks at a recording before there is a study.
struct RecordingViewer {
  /// Whether a table is of this kind, by its columns.
  bool (*takes)(const RecordedTable& table);
  /// Adds every fault to `faults`; nothing where it cannot be read.
  std::optional<RecordingLook> (*look)(const std::filesystem::path& file, const RecordedTable& table,
                                       Diagnostics& faults);
};

/// Columns with numbers in a unit that is known.
std::vector<RecordedChannel> ChannelsInKnownUnits(const RecordedTable& table, const RecordingSummary& summary);

/// Why a fit would not take a recording that the reader took; empty where it takes all of them.
using FurtherRefusals = std::function<std::vector<std::string>(const TimeRecording&)>;

/// A table over time by its columns, and why a fit to these channels would not take it: by the reader that fits use,
/// and by `further`.
RecordingLook LookOverTime(const std::filesystem::path& file, const RecordedTable& table,
                           const RecordingSummary& summary, const std::vector<RecordedChannel>& channels,
                           const FurtherRefusals& further);

/// "line 3: ... [id]"
std::string RefusalText(const Diagnostic& fault);

}  // namespace fourpost
