#pragma once

#include <string>

#include "identify/study/loaded_study.h"

namespace fourpost {

/// What the sensors of a study read at rest, as lines 'noise' for the entries of its 'histories', by the names of the
/// vehicle's sensors; of those that state none. Empty without such.
std::string NoiseAtRestText(const LoadedStudy& study);

}  // namespace fourpost
