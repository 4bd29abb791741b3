#pragma once

#include <optional>
#include <string>

#include "analysis/process/work_hooks.h"
#include "vehicles/engine/steady_response.h"

namespace fourpost {

/// Throws FaultyInput, naming the unstable modes, for a vehicle that has no steady response.
void RequireStable(const Vehicle& vehicle, const SteadySolver& solver);

/// Solves, shows progress, and lists the frequencies that were integrated in time. `name`: of the sweep. If stopped,
/// the frequencies not yet integrated have no result and are marked. Empty if harmonic balance itself was stopped
/// before any result. Throws FaultyInput for a vehicle that the engine does not accept, else as SteadySolver::Solve
/// does.
std::optional<SteadyResponse> SolveSweep(SteadySolver& solver, const std::string& name, const Excitation& excitation,
                                         Engine engine, const HarmonicBalanceOptions& options, const WorkHooks& hooks);

}  // namespace fourpost
