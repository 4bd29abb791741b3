#pragma once

#include <vector>

#include "identify/choice/knob.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// The knobs under 'knobs' of a file of settings, for this vehicle. Faults go to the map's diagnostics.
std::vector<Knob> ReadKnobs(const StrictMap& top, const Vehicle& vehicle);

}  // namespace fourpost
