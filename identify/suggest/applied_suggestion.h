#pragma once

#include <filesystem>
#include <string>

#include <Eigen/Core>

#include "identify/study/loaded_study.h"
#include "identify/suggest/suggestions.h"

namespace fourpost {

/// The vehicle file and the study with a suggestion, to be written into `folder` as vehicle.urdf and study.yaml.
/// Parameters begin at their fitted `values`, those with a prior at its centre.
struct AppliedSuggestion {
  std::string vehicle;
  std::string study;
};
AppliedSuggestion Apply(const LoadedStudy& study, const Eigen::VectorXd& values, const SuggestedAddition& suggestion,
                        const std::filesystem::path& folder);

}  // namespace fourpost
