#pragma once

#include <vector>

#include "analysis/diagnostics.h"
#include "identify/four_post_data.h"
#include "identify/loaded_study.h"
#include "identify/study.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What recordings are held against: channels at their lines of the study, its band, and the vehicle at some values.
struct RunLint {
  const Study& study;
  const Vehicle& vehicle;
  const CondensedModel& model;
  /// Of posts that certainly move otherwise than told.
  Severity wrong_posts = Severity::kWarning;
};

/// What in stepped-sine responses can hardly be so, as warnings (but see RunLint::wrong_posts): an accelerometer that
/// does not move with its body below 1 Hz, where that is rigid (its station is wrong by far, or its sign, or its
/// scale); posts that are told to move otherwise than the car shows below 1 Hz, where it follows them; a channel of
/// another sign than the vehicle has. Returns those runs whose posts are as told.
std::vector<MeasuredRun> LintRuns(const RunLint& lint, const std::vector<MeasuredRun>& runs, Diagnostics& diagnostics);

/// The same of a study at the values of its vehicle's file; a load cell that feels a wheelpan the vehicle does not
/// have, or the other way round; static loads that no masses within their bounds make. Nothing for a study without
/// stepped sines and static loads. Throws FaultyInput when the vehicle cannot be assembled.
void LintRecordings(const LoadedStudy& study, Diagnostics& diagnostics, Severity wrong_posts = Severity::kWarning);

}  // namespace fourpost
