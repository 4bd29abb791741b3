#pragma once

#include <cstdint>

#include "tests/peers/peer_objective.h"
#include "tests/peers/peer_settings.h"

namespace fourpost {

/// One start of scipy's differential_evolution (Virtanen et al., Nature Methods 17, 2020) on the unit cube, in a Python
/// process that serves all starts of a thread: scipy_de.py tells the protocol. `variant` is 1 best1bin, 2 rand1bin,
/// 3 best1exp, 4 rand1exp, 5 currenttobest1bin, 6 randtobest1bin; the factor is drawn from `factor_lower` to
/// `factor_upper` for each generation. Its final polishing is off: a lattice has no gradient.
/// Throws PeerStop, and std::runtime_error when Python does not answer.
void MinimiseByScipyDe(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed);

}  // namespace fourpost
