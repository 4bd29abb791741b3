#pragma once

#include "vehicles/lint/lint_subject.h"

namespace fourpost {

/// Parameters without effect on motion, static loads and sensor readings.
void LintIdleParameters(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
