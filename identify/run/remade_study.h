#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "identify/run/growth_path.h"
#include "identify/suggest/addition.h"

namespace fourpost {

/// A study, the values that it was given (see FitRequest), and the additions to make, in order.
struct RemakeRequest {
  std::filesystem::path study;
  std::vector<std::string> set;
  std::vector<GrowthAddition> additions;
  /// Of parameters by name, SI, where they are to begin; others begin at their own.
  std::map<std::string, double> values;
};

/// Which of those offered is the one wanted: of its mechanism and elements that with the same words and number, else
/// with the same words, for numbers change with what is offered beside it; else with the same number, or any.
std::optional<std::size_t> PlaceOf(const GrowthAddition& wanted, const std::vector<Addition>& offered);

/// Writes study.yaml and vehicle.urdf of the study with these additions into a folder. False where one of them cannot
/// be made without others that are not among them; nothing is left in the folder then. Throws FaultyInput and
/// OutputError.
bool RemakeStudy(const RemakeRequest& request, const std::filesystem::path& folder);

}  // namespace fourpost
