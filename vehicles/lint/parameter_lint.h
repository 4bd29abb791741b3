#pragma once

#include "vehicles/lint/lint_subject.h"

namespace fourpost {

/// Parameters that change neither the motion nor a static load nor what a sensor reads.
void LintIdleParameters(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
