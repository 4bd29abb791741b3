#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/files/recorded_table.h"
#include "analysis/files/time_recording.h"
#include "analysis/frequency_response/rig_signals.h"
#include "analysis/measured_response/posts_by_name.h"
#include "analysis/measured_response/stated_unit.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// What is stated of a time history beside the names of its posts.
struct RigPreparation {
  /// Of its times, and the files that were recorded beside it.
  TimePreparation times = {};
  /// The column of times; empty: TimesColumn().
  std::optional<RecordedChannel> time = {};
  /// Unit, offset, drift and delay of channels, posts too, by the first of their names.
  std::vector<RecordedChannel> channels = {};
  /// What is before and after is left out.
  std::optional<double> start_s = {};
  std::optional<double> end_s = {};
  /// In place of what the files have; times too. The last one that names a channel counts.
  std::vector<StatedUnit> units = {};
};

/// A time history of a rig in SI: displacements of posts, and all other channels in a unit of a length, a force, an
/// acceleration or an angular velocity.
struct RigRecording {
  double rate_Hz = 0;
  /// What the posts are called, and their displacements.
  std::vector<std::string> posts;
  std::vector<std::string> post_channels;
  std::vector<std::vector<double>> heights;
  std::vector<std::string> names;
  /// "m", "N", "m/s^2" or "rad/s".
  std::vector<std::string> units;
  std::vector<std::vector<double>> channels;
  /// Columns in other units, or without one; and those of them whose unit is not known, as 'oil [foo]'.
  std::vector<std::string> left_out;
  std::vector<std::string> unit_unknown;
  /// What was done to it, a sentence each.
  std::vector<std::string> preparations = {};

  RigSignals Signals() const;
  double duration_s() const;
};

/// Reads a time history; posts by PostsByName() where `posts` is empty, which `preparations` then names. Adds every
/// fault; nothing when there was one.
std::optional<RigRecording> ReadRigRecording(const std::filesystem::path& file, std::span<const PostChannel> posts,
                                             Diagnostics& diagnostics, const RigPreparation& preparation = {});

}  // namespace fourpost
