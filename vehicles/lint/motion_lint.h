#pragma once

#include "vehicles/lint/lint_subject.h"

namespace fourpost {

/// Motions without stiffness.
void LintFreeMotions(const LintSubject& subject, FileFaults& findings);

/// Sensors that no small motion moves.
void LintBlindSensors(const LintSubject& subject, FileFaults& findings);

/// Modes below 30 Hz with very low damping: damping ratio below 0.5 %, and no friction in them.
void LintRingingModes(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
