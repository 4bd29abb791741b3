#pragma once

#include <string>

#include "identify/command_line/commands.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// How the posts move, and when.
struct Drive {
  /// "sweep from 0.5 to 30 Hz in heave"
  std::string name;
  PostMotion motion;
  double start_s = 0;
  double end_s = 0;
  double lead_s = 0;
  /// Highest frequency of what the posts are asked to do; 0: none in particular.
  double upper_Hz = 0;
};

/// Adds an error for each option that this vehicle's posts cannot follow or that does not go with the others: mode,
/// limits, stroke; too low a rate, a filter beyond it, more samples than can be, a duration that ends before a step
/// does. Before any motion is made; a recording, whose duration is not known yet, holds what it holds.
void CheckMotion(const SimulateCommand& command, const Vehicle& vehicle, Diagnostics& diagnostics);

/// The motion asked for, of which CheckMotion found no fault. Adds warnings of what lies outside the model's range, see
/// WarnAboveRigid and WarnBeyondUsual. Throws FaultyInput for what the posts of this vehicle cannot do, that they would
/// leave their stroke included, and for a recording that cannot be read.
Drive DriveOf(const SimulateCommand& command, const Vehicle& vehicle, Diagnostics& findings);

}  // namespace fourpost
