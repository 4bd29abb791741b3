#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "analysis/units.h"

namespace fourpost {

/// A column that is wanted from a recording.
struct RecordedChannel {
  /// The first that the file has is read; messages call it by the first.
  std::vector<std::string> names;
  Dimension dimension;
  /// For messages: "the height of a post".
  std::string what;
};

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

/// Reads a CSV file of names and, below them, units: a column `time`, and those wanted. Other columns do not count.
/// Reports all of: columns that are missing, units of another dimension, fields that are no numbers, fewer than four
/// samples, gaps, times that step back or are not evenly spaced. Nothing when there was one.
std::optional<TimeRecording> ReadTimeRecording(const std::filesystem::path& file,
                                               std::span<const RecordedChannel> wanted, Diagnostics& diagnostics);

}  // namespace fourpost
