#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/search/archive.h"

namespace fourpost {

/// Names of parameters without effect: the cost stays the same, to the last bit, over four values across their range,
/// about two points of the search space. All of them: the objective is constant. Those points count as evaluations.
std::vector<std::string> IdleParameters(Archive& archive);

/// What would make a search of this problem pointless, as findings about `file`: a constant objective is an
/// error, a parameter without effect a warning. Pays as IdleParameters().
void CheckEffects(Archive& archive, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
