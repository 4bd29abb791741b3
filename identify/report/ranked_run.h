#pragma once

#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/report/compared_run.h"
#include "identify/uncertainty/model_ranking.h"

namespace fourpost {

/// What `fourpost rank` ranks. Reports all runs that are not of bench recordings, or of other data, fitted or kept for
/// validation, than the first one's.
std::vector<FittedModel> FittedModels(const std::vector<ComparedRun>& runs, Diagnostics& diagnostics);

}  // namespace fourpost
