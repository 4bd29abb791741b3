#pragma once

#include "vehicles/lint/lint_subject.h"

namespace fourpost {

/// Balls, welds and hinges whose points do not coincide as written, so that closing them moves bodies from their drawn
/// position.
void LintOpenClosures(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
