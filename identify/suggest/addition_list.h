#pragma once

#include <vector>

#include "identify/study/loaded_study.h"
#include "identify/suggest/addition.h"

namespace fourpost {

/// All that could be added to a study's vehicle and to what it says of its channels, alternatives numbered. `values`:
/// of all parameters of the vehicle, SI.
std::vector<Addition> AllAdditions(const LoadedStudy& study, const std::vector<double>& values);

}  // namespace fourpost
