#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/report/compared_run.h"
#include "identify/uncertainty/model_ranking.h"

namespace fourpost {

/// Which run fits best, which predicts best and which is recommended, as HTML; and what makes that doubtful.
/// `ranking`: that of `fourpost rank`, where it can rank these runs.
std::string VerdictHtml(const std::vector<ComparedRun>& runs, const std::optional<ModelRanking>& ranking);

}  // namespace fourpost
