#pragma once

#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What recordings are held against: channels at their lines of the study, its band, and the vehicle at some values.
struct RunLint {
  const FourPostPlan& plan;
  const Vehicle& vehicle;
  const CondensedModel& model;
  /// Of posts that certainly move otherwise than stated.
  Severity wrong_posts = Severity::kWarning;
};

/// Implausible stepped-sine responses, as warnings (but see RunLint::wrong_posts): an accelerometer that does not move
/// with its body below 1 Hz, where that is rigid (its position is wrong by far, or its sign, or its scale); posts that
/// move otherwise than stated, as the car shows below 1 Hz, where it follows them; a channel of another sign than the
/// vehicle has. Returns those runs whose posts are as stated.
std::vector<MeasuredRun> LintRuns(const RunLint& lint, const std::vector<MeasuredRun>& runs, Diagnostics& diagnostics);

}  // namespace fourpost
