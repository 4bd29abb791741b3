#pragma once

#include <cstdint>

#include "tests/peers/peer_objective.h"
#include "tests/peers/peer_settings.h"

namespace fourpost {

/// One start of an algorithm of NLopt (Johnson, https://github.com/stevengj/nlopt) on the unit cube from a random
/// point. Throws PeerStop. NLopt draws from a stream per thread.

/// Controlled random search with local mutation; it needs more members than parameters and gets at least as many.
void MinimiseByNloptCrs2(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed);

/// Improved stochastic ranking evolution strategy; constraints reach it as costs alone.
void MinimiseByNloptIsres(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed);

}  // namespace fourpost
