#pragma once

#include <filesystem>
#include <optional>

#include "analysis/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Heights of posts that a rig recorded.
struct RecordedPosts {
  /// Each post follows the spline of continuous curvature through its samples (UniformSpline), with the slopes at both
  /// ends of the cubic through the four samples there. Before the record it rises from rest at height 0 to the height
  /// and velocity of the first sample.
  PostMotion motion;
  /// Of the first and the last sample.
  double start_s = 0;
  double end_s = 0;
  double step_s = 0;
  /// How long before start_s the posts begin to move.
  double lead_s = 0;
};

/// Reads a CSV file of names and, below them, units: a column `time`, and one for each post of the vehicle, `FL` or
/// `post_FL` for the post 'FL', in a unit of length, upward from where the posts stand under the resting vehicle. Other
/// columns do not count. Reports all of: columns that are missing, units of another dimension, fields that are no
/// numbers, gaps, times that are not evenly spaced, records too short. Nothing when there was one.
std::optional<RecordedPosts> ReadRecordedPosts(const std::filesystem::path& file, const Vehicle& vehicle,
                                               Diagnostics& diagnostics);

}  // namespace fourpost
