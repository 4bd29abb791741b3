#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/files/recorded_table.h"
#include "analysis/text/diagnostics.h"
#include "analysis/text/units.h"

namespace fourpost {

class RecordedTable;

/// A column that is wanted from a recording.
struct RecordedChannel {
  /// The first that the file has is read; messages call it by the first.
  std::vector<std::string> names;
  Dimension dimension;
  /// For messages: "the height of a post".
  std::string what;
  /// In place of the unit that the file has; empty: that.
  std::string unit = "";
  /// Sign and scale, which values in SI are multiplied by.
  double factor = 1;
  /// By which it comes later than what it measures; taken back by a cubic spline through the samples.
  double delay_s = 0;
};

/// The column of times unless a study names another.
inline const RecordedChannel kTimeColumn{
    {"time", "Time", "TIME", "t", "timestamp", "Timestamp", "datetime", "DateTime"}, kTime, "the time of each sample"};

/// Signals sampled at once and evenly.
struct TimeRecording {
  /// Of the first and the last sample.
  double start_s = 0;
  double end_s = 0;
  double step_s = 0;
  /// One per channel wanted, in its order; SI, as measured, offsets included.
  std::vector<std::vector<double>> channels;

  std::size_t samples() const { return channels.empty() ? 0 : channels.front().size(); }
  double rate_Hz() const { return 1 / step_s; }
  double time_s(std::size_t sample) const { return start_s + step_s * static_cast<double>(sample); }
};

/// Reads a recording from any file that RecordedTable reads: times, and the columns wanted. Other columns do not
/// count. What delays leave unknown at the ends is cut off. Reports all of: columns that are missing, that have no
/// unit, one that is unknown or of another dimension, fields that are no numbers, fewer than four samples, gaps, times
/// that step back or are not evenly spaced. Nothing when there was one.
std::optional<TimeRecording> ReadTimeRecording(const std::filesystem::path& file,
                                               std::span<const RecordedChannel> wanted, Diagnostics& diagnostics,
                                               const RecordedChannel& time = kTimeColumn);
/// Likewise of a file that has been read.
std::optional<TimeRecording> ReadTimeRecording(const RecordedTable& table, std::span<const RecordedChannel> wanted,
                                               Diagnostics& diagnostics, const RecordedChannel& time = kTimeColumn);

/// Reports what ReadTimeRecording would of a table, and keeps no channel: the record may be larger than memory.
void CheckTimeRecording(const RecordedTable& table, std::span<const RecordedChannel> wanted, Diagnostics& diagnostics,
                        const RecordedChannel& time = kTimeColumn);

}  // namespace fourpost
