#pragma once

#include "vehicles/lint_subject.h"

namespace fourpost {

/// Rates, masses and radii that no road vehicle has, as when kN were meant. Zero is no slip of a unit.
void LintNumbers(const LintSubject& subject, FileFaults& findings);

/// Cubic terms that far outdo the linear ones within a small travel.
void LintHardening(const LintSubject& subject, FileFaults& findings);

/// Points given in millimetres where metres are meant; of sensors see LintSensorPlaces.
void LintPlacesInMillimetres(const LintSubject& subject, FileFaults& findings);

/// Stops that touch on both sides in the design pose.
void LintStopGaps(const LintSubject& subject, FileFaults& findings);

/// Dampers that resist compression far more than rebound.
void LintSwappedDamping(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
