#pragma once

#include "analysis/files/recording/recording.h"

namespace fourpost {

/// Names channels that have none "channel 3", and gives those of one name their group or point in front or behind, then
/// a number, so that a study can name each.
void MakeNamesUnique(Recording& recording);

}  // namespace fourpost
