#pragma once

#include "vehicles/lint_subject.h"

namespace fourpost {

/// Motions that meet no stiffness.
void LintFreeMotions(const LintSubject& subject, FileFaults& findings);

/// Oscillations in heave, roll or pitch that no damper damps. In the plane of the platforms a car is undamped by
/// nature of the tyre's law.
void LintUndampedMotions(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
