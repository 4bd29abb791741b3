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
  /// What it reads at zero; goes before sign and scale.
  std::optional<Quantity> offset = {};
  /// Its straight line is taken away, or what is slower than this, see RemoveSlow().
  bool has_trend = false;
  std::optional<double> high_pass_Hz = {};
  /// Of a length that was recorded as a velocity or an acceleration: it is integrated, and what is slower than this is
  /// taken away each time.
  std::optional<double> integrated_above_Hz = {};
};

/// Another file that was recorded beside the first.
struct OtherFile {
  std::filesystem::path path;
  /// By which its clock is ahead: its times less those of the first file.
  double delay_s = 0;
};

/// What is done to the times of a recording before it is used.
struct TimePreparation {
  /// Even times of this rate, which channels are interpolated at; not below the recorded one.
  std::optional<double> rate_Hz = {};
  /// Up to which gaps are bridged by interpolation; 0: none are.
  double bridge_s = 0;
  /// Where channels are looked for that the first file does not have.
  std::vector<OtherFile> others = {};

  bool IsGridded() const { return rate_Hz || bridge_s > 0; }
};

/// The column of times unless a study names another.
inline const RecordedChannel kTimeColumn{
    {"time", "Time", "TIME", "t", "timestamp", "Timestamp", "datetime", "DateTime"}, kTime, "the time of each sample"};

/// "2 ms", to a microsecond.
std::string MillisecondsText(double time_s);
/// "a_body: delay of 2 ms taken back", of what is done to a recording.
std::string DelayTakenBack(const std::string& channel, double delay_s);
/// "cut to 2 .. 8.5 s"
std::string CutTo(double start_s, double end_s);

/// Between two samples of a channel; values there are interpolated.
struct BridgedGap {
  double from_s = 0;
  double to_s = 0;

  bool operator==(const BridgedGap&) const = default;
};

/// Signals sampled at once and evenly.
struct TimeRecording {
  /// Of the first and the last sample.
  double start_s = 0;
  double end_s = 0;
  double step_s = 0;
  /// One per channel wanted, in its order; SI, as measured, offsets included unless they are stated.
  std::vector<std::vector<double>> channels;
  /// Of each channel.
  std::vector<std::vector<BridgedGap>> gaps = {};
  /// What was done to it, a sentence each.
  std::vector<std::string> preparations = {};

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
                                               const RecordedChannel& time = kTimeColumn,
                                               const TimePreparation& preparation = {});
/// Likewise of a file that has been read; without other files.
std::optional<TimeRecording> ReadTimeRecording(const RecordedTable& table, std::span<const RecordedChannel> wanted,
                                               Diagnostics& diagnostics, const RecordedChannel& time = kTimeColumn,
                                               const TimePreparation& preparation = {});

/// Reports what ReadTimeRecording would of a table, and keeps no channel: the record may be larger than memory.
void CheckTimeRecording(const RecordedTable& table, std::span<const RecordedChannel> wanted, Diagnostics& diagnostics,
                        const RecordedChannel& time = kTimeColumn);

}  // namespace fourpost
