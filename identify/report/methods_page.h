#pragma once

#include <string>

#include "identify/comparison/comparison.h"

namespace fourpost {

/// What `fourpost compare` found, as one self-contained HTML file. `study`: the problem's name. `rule`: what counted as
/// solved, in words. With `time` also processor time.
std::string MethodsPage(const Comparison& comparison, const std::string& study, const std::string& rule, bool time);

}  // namespace fourpost
