#pragma once

#include <string>
#include <vector>

#include "identify/fit/fit.h"

namespace fourpost {

/// A panel for each profile, in the units of the vehicle file: the rise of the cost over the parameter's value, the
/// parabola of the linear deviation and the level of 95 %. SVG text. `fit` has at least one profile.
std::string ProfileSvg(const FitResult& fit);

}  // namespace fourpost
