#pragma once

#include <string>
#include <vector>

#include "identify/study_file/calibration.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// `calibration: {gain: {accelerometers: 1 %}, delay: {posts: 1 ms}, offset: {static_loads: 50 N}}`. Adds every fault
/// to `diagnostics`.
std::vector<Calibration> ReadCalibrations(const YAML::Node& node, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
