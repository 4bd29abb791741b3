#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/comparison/comparison.h"

namespace fourpost {

/// pagmo_de, pagmo_sade, pagmo_cmaes, nlopt_crs2, nlopt_isres, scipy_de.
std::vector<std::string_view> PeerNames();

/// The peer that `text` names, its settings changed by what follows: "pagmo_de:population=40:factor=0.7". Every peer
/// has `population`, `patience` (populations asked for without a better cost, after which it starts anew from another
/// seed; 0: never) and `logarithmic` (PeerRules). Throws FaultyInput about --methods.
ComparedMethod PeerMethod(std::string_view text);

/// Takes the peers out of `names`. Adds faults, names of ours excepted, to `diagnostics`.
std::vector<ComparedMethod> TakePeers(std::vector<std::string>& names, Diagnostics& diagnostics);

}  // namespace fourpost
