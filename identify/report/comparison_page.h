#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/model_ranking.h"
#include "identify/report/run_contents.h"

namespace fourpost {

/// Several runs of fits side by side as one self-contained HTML file: names of their folders, and what those hold.
/// `ranking`: where `fourpost rank` can rank them. Throws FaultyInput for a run that is no fit's, and
/// nlohmann::json::exception for one that is not understood.
std::string ComparisonPage(std::vector<std::pair<std::string, RunContents>> folders,
                           const std::optional<ModelRanking>& ranking);

}  // namespace fourpost
