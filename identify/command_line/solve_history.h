#pragma once

#include <optional>
#include <vector>

#include "identify/command_line/commands.h"
#include "identify/command_line/drive.h"
#include "vehicles/response/friction_lock.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// What an engine answers, and what is to be said about it.
struct SolvedHistory {
  /// The lead included.
  TimeHistory history;
  /// Condensed: step, and what its last halving changed; nothing where no two steps were compared.
  std::optional<double> step_s;
  std::optional<double> change;
  /// The user ended it: what there is, see CondensedHistory::ended.
  bool interrupted = false;
  /// Dampers that never slid in a history that was not interrupted.
  std::vector<LockedFriction> locked;
};

/// Runs the engine asked for and shows how it gets on, until it ends or Interrupted(). Adds a warning of a vehicle that
/// falls over. Throws FaultyInput when it cannot be assembled or held in its design pose.
SolvedHistory SolveHistory(const SimulateCommand& command, const Vehicle& vehicle, const Drive& drive,
                           Diagnostics& findings);

}  // namespace fourpost
