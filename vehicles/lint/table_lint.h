#pragma once

#include "vehicles/description/drawn_vehicle.h"
#include "vehicles/lint/lint_subject.h"

namespace fourpost {

/// Curves of dampers whose points beside rest give a force there, which no damper has.
void LintDamperTables(const DrawnVehicle& drawn, FileFaults& findings);

/// Curves of springs that state no place on them, and give another force at their zero than the spring carries.
void LintSpringTables(const LintSubject& subject, FileFaults& findings);

/// Tyres that carry another load at rest than their curve holds.
void LintTyreTables(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
