#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/comparison/comparison.h"
#include "identify/study/study.h"

namespace fourpost {

/// The methods of these names for a problem: the study's own before presets of kMethodNames. Adds every fault to
/// `diagnostics`: of the option --methods unknown names and names that stand twice, and of the study's methods unknown
/// settings and values out of bounds, with file and line.
std::vector<ComparedMethod> MethodsOf(const Study& study, const std::vector<std::string>& names, const Problem& problem,
                                      Diagnostics& diagnostics);

/// How a fit explores before it refines: by `search: method`, with its population. Adds every fault to `diagnostics`.
MethodOptions ExplorationOf(const Study& study, const Problem& problem, Diagnostics& diagnostics);

}  // namespace fourpost
