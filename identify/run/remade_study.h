#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "identify/run/growth_path.h"

namespace fourpost {

/// A study, the values that it was given (see FitRequest), and the additions to make, in order.
struct RemakeRequest {
  std::filesystem::path study;
  std::vector<std::string> set;
  std::vector<GrowthAddition> additions;
  /// Of parameters by name, SI, where they are to begin; others begin at their own.
  std::map<std::string, double> values;
};

/// Writes study.yaml and vehicle.urdf of the study with these additions into a folder. False where one of them cannot
/// be made without others that are not among them; nothing is left in the folder then. Throws FaultyInput and
/// OutputError.
bool RemakeStudy(const RemakeRequest& request, const std::filesystem::path& folder);

}  // namespace fourpost
