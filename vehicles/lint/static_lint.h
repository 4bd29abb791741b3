#pragma once

#include "vehicles/lint/lint_subject.h"

namespace fourpost {

/// Tyres that pull on their platform at rest.
void LintTyreLoads(const LintSubject& subject, FileFaults& findings);

/// Springs under tension at rest, among those whose preload equilibrium sets.
void LintSpringLoads(const LintSubject& subject, FileFaults& findings);

/// A weight that the tyres do not carry.
void LintWeightOnTyres(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
