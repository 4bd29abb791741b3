#pragma once

#include <optional>
#include <string>

#include "identify/command_line/added_load.h"
#include "identify/command_line/commands.h"
#include "identify/study.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A fit's vehicle, and the study that it was fitted by.
struct FittedRun {
  Vehicle vehicle;
  Study study;
  /// Whether the fit has seen the recording that is to be predicted.
  bool has_seen = false;
  /// Already on `vehicle`.
  std::optional<AddedLoad> load;
};

/// What stands above the errors: the added load, where there is one.
std::string LoadText(const FittedRun& model);

/// Tells how well the model predicts a stepped sine, within the study's band. Returns an ExitCode. Throws FaultyInput.
int PredictResponses(const PredictCommand& command, const FittedRun& model);

}  // namespace fourpost
