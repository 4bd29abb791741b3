#pragma once

#include <vector>

#include "identify/command_line/commands.h"
#include "identify/command_line/drive.h"
#include "vehicles/engine/history_solver.h"
#include "vehicles/response/friction_lock.h"
#include "vehicles/response/tyre_pull.h"

namespace fourpost {

/// What an engine answers, and what is to be said about it.
struct AnsweredHistory {
  SolvedHistory answer;
  /// Dampers that never slid in a history that was not interrupted.
  std::vector<LockedFriction> locked;
  /// Tyres with liftoff="false" that pulled.
  std::vector<TyrePull> pulls;
};

/// Runs the engine asked for and shows how it gets on, until it ends or Interrupted(). Adds a warning of a vehicle that
/// falls over. Throws FaultyInput when it cannot be assembled or held in its design pose.
AnsweredHistory SolveHistory(const SimulateCommand& command, const Vehicle& vehicle, const Drive& drive,
                             Diagnostics& findings);

}  // namespace fourpost
