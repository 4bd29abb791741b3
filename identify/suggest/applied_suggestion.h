#pragma once

#include <filesystem>
#include <string>

#include "identify/study/loaded_study.h"
#include "identify/suggest/suggestions.h"

namespace fourpost {

/// The vehicle file and the study with a suggestion, to be written into `folder` as vehicle.urdf and study.yaml.
/// Parameters begin where the suggestion has them, those with a prior at its centre.
struct AppliedSuggestion {
  std::string vehicle;
  std::string study;
};
AppliedSuggestion Apply(const LoadedStudy& study, const SuggestedAddition& suggestion,
                        const std::filesystem::path& folder);

}  // namespace fourpost
