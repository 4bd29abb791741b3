#pragma once

#include "vehicles/lint/lint_subject.h"

namespace fourpost {

/// Balls, welds and hinges whose points are apart as written, so that closing them moves bodies from where they were
/// drawn.
void LintOpenClosures(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
