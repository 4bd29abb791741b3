#pragma once

#include <filesystem>

#include "identify/run/fit_run.h"

namespace fourpost {

/// Copies the results of a step into the output of a growth that was stopped, and says there what is not done.
/// Evaluates nothing, so that it takes a moment. `fit`: of the step, as far as it is known. Throws OutputError, and
/// FaultyInput where the step's files are damaged.
FitRun WriteUnfinishedGrowth(const std::filesystem::path& step, const std::filesystem::path& output,
                             const GrowthSummary& growth, FitRun fit);

}  // namespace fourpost
