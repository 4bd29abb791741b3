#pragma once

#include <optional>
#include <string>

#include "identify/command_line/progress_line.h"
#include "vehicles/engine/steady_response.h"

namespace fourpost {

/// Throws FaultyInput, naming the modes that grow, for a vehicle that has no steady response.
void RequireStable(const Vehicle& vehicle, const SteadySolver& solver);

/// Solves, shows how it gets on, and tells on stderr which frequencies were left to the march. `name`: of the sweep.
/// Ends when Interrupted(): frequencies that were not marched yet have no answer then, and say so; nothing where a
/// balance had answered none, for what it leaves to the march belongs to it.
/// Throws FaultyInput for a vehicle that the engine does not take, else as SteadySolver::Solve does.
std::optional<SteadyResponse> SolveSweep(SteadySolver& solver, const std::string& name, const Excitation& excitation,
                                         Engine engine, const HarmonicBalanceOptions& options, ProgressLine& progress);

}  // namespace fourpost
