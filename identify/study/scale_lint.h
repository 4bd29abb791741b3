#pragma once

#include "analysis/text/diagnostics.h"
#include "identify/study/loaded_study.h"

namespace fourpost {

/// A study whose data determine masses, rates and dampings up to a common factor only, since it fits no force, load or
/// prior: what is held sets that factor, and no deviation knows of it. Names held parameters as far as they set it.
/// Evaluates the model a few times.
void LintScale(const LoadedStudy& study, Diagnostics& diagnostics);

}  // namespace fourpost
