#pragma once

#include <optional>

#include "identify/study_file/strict_yaml.h"

namespace fourpost {

struct FrequencyBand {
  double lower_Hz = 0;
  double upper_Hz = 0;
};

/// `band: [0.5 Hz, 30 Hz]` of a map that has it: rising, up to 200 Hz. Nothing after a fault.
std::optional<FrequencyBand> ReadFrequencyBand(const StrictMap& map);

}  // namespace fourpost
