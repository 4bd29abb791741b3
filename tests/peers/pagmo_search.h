#pragma once

#include <cstdint>

#include "tests/peers/peer_objective.h"
#include "tests/peers/peer_settings.h"

namespace fourpost {

/// One start of an algorithm of pagmo 2 (Biscani and Izzo, J. Open Source Softw. 5, 2020) on the unit cube: until
/// PeerStop, which passes through. Its own tolerances are off: on a lattice costs that are alike say nothing.

/// Differential evolution; `variant` 1..10 as pagmo numbers them, of which 2 is rand/1/exp, 6 best/1/bin, 7 rand/1/bin.
void MinimiseByPagmoDe(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed);

/// Self-adaptive differential evolution; `adaptation` 1 is jDE, 2 iDE.
void MinimiseByPagmoSade(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed);

/// CMA-ES, kept within the bounds; `deviation` is the initial one.
void MinimiseByPagmoCmaes(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed);

}  // namespace fourpost
