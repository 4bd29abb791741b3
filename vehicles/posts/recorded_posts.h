#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// A causal Butterworth low-pass.
struct LowPassDesign {
  int order = 4;
  double cutoff_Hz = 0;

  /// Part of a record's end that a filter still holds, with a margin: four periods of the cut-off [s].
  double UnknownEnd_s() const { return 4 / cutoff_Hz; }
};

/// Heights of posts that a rig recorded.
struct RecordedPosts {
  /// Each post follows the spline of continuous curvature (UniformSpline) through its samples and, every 0.4 ms at
  /// least, values between them by polynomials of order 15, with the slopes at both ends of the cubic through the four
  /// values there. Before the record it rises from rest at height 0 to the height
  /// and velocity of the first sample.
  PostMotion motion;
  std::size_t count = 0;
  /// Of the first and the last sample.
  double start_s = 0;
  double end_s = 0;
  double step_s = 0;
  /// How long before start_s the posts begin to move.
  double lead_s = 0;
};

/// Posts through samples of their heights at start + k step, one vector per post. `filter`: the low-pass of the
/// recorded heights. It is inverted (Unfiltered) up to 1.5 times its cut-off, faded out to 2.5 times, so that the posts
/// move as they did on the rig and not as recorded; the last UnknownEnd_s() of the record remain unknown then.
/// `tensions`: of actuators, behind the posts. These come to their first value without a slope, which noise would
/// decide.
RecordedPosts FollowHeights(const std::vector<std::vector<double>>& heights, double start_s, double step_s,
                            const LowPassDesign* filter = nullptr,
                            const std::vector<std::vector<double>>& tensions = {});

/// Reads a CSV file of names and, below them, units: a column `time`, and one for each post of the vehicle, `FL` or
/// `post_FL` for the post 'FL', in a unit of length, upward from the position under the resting vehicle; and, where
/// there is one of its name, the tension of each actuator. Other columns are ignored. Reports all of: missing columns,
/// units of another dimension, fields that are no numbers, gaps, times that are not evenly spaced, records too short.
/// Empty after any of these.
std::optional<RecordedPosts> ReadRecordedPosts(const std::filesystem::path& file, const Vehicle& vehicle,
                                               Diagnostics& diagnostics);

}  // namespace fourpost
