#pragma once

#include <string>

#include "identify/comparison/comparison.h"

namespace fourpost {

/// Share of each method's runs that had solved the problem, over their evaluations, as an SVG document.
/// Of a comparison in which a run solved it.
std::string MethodsSvg(const std::string& title, const Comparison& comparison);

}  // namespace fourpost
