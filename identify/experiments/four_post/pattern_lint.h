#pragma once

#include <optional>
#include <string>

#include "identify/experiments/four_post/four_post_data.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What is wrong with the motion of the posts that a stepped sine is told to have.
struct PatternFault {
  std::string text;
  /// They clearly move otherwise; else like nothing that these posts can make.
  bool is_certain = false;
};

/// At low frequencies, where a car follows its posts whatever its parameters are, its accelerations and forces look
/// like another motion, or like none that these posts can make. Nothing where they are as told, and where they cannot
/// tell: no frequency is low enough. `run`: over all its frequencies.
std::optional<PatternFault> PatternDoubt(const Vehicle& vehicle, const CondensedModel& model, const MeasuredRun& run);

}  // namespace fourpost
