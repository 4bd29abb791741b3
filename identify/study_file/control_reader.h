#pragma once

#include <optional>
#include <string>

#include "identify/study_file/control.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// Adds every fault to `diagnostics`.
StudyControl ReadStudyControl(const YAML::Node& node, const std::string& file, Diagnostics& diagnostics);

/// A recording's setting, "1.5", "1.5 A" or "4 clicks"; what stands behind the number is for the reader. Nothing where
/// the key is missing; a fault where it is no number.
std::optional<double> ReadSetting(const StrictMap& recording);

}  // namespace fourpost
