#pragma once

#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/comparison.h"
#include "identify/study.h"

namespace fourpost {

/// The methods of these names for a problem: the study's own before presets of kMethodNames. Adds every fault to
/// `diagnostics`: unknown names, names that stand twice, and of the study's methods unknown settings and values out of
/// bounds, with file and line.
std::vector<ComparedMethod> MethodsOf(const Study& study, const std::vector<std::string>& names, const Problem& problem,
                                      Diagnostics& diagnostics);

}  // namespace fourpost
