#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fourpost {

/// A signal of a recording, in the words of its file.
struct RecordingChannel {
  std::string name;
  /// As written; empty where the file has none.
  std::string unit;
  /// Group of TDMS, MDF and HDF5; empty where the format has none.
  std::string group = "";
  /// Node and direction, "12 +Z", of universal files; else empty.
  std::string point = "";
  /// What the file says of it beside its name, as the ID lines of universal files; else empty.
  std::string description = "";
  std::size_t samples = 0;
  /// Of evenly spaced samples: first time, and step; a step of 0 means that they are not, or that nothing says when.
  double start_s = 0;
  double step_s = 0;
  /// Number of the times of its own that RecordingFile::Times reads; channels of one clock have the same.
  std::optional<std::size_t> clock = std::nullopt;
  /// Of one count, where the file holds integers and a factor; else 0.
  double count = 0;
  /// In `unit`; empty until they are read.
  std::vector<double> values = {};
  /// Of channels with a clock, in s; empty until they are read.
  std::vector<double> times_s = {};

  bool HasTimes() const { return step_s > 0 || clock; }
};

/// Signals that were recorded together, at one rate or at several.
struct Recording {
  /// "RPC III", "TDMS", ...
  std::string format;
  /// What the file says about itself; lines, perhaps none.
  std::string description;
  std::vector<RecordingChannel> channels = {};
};

}  // namespace fourpost
