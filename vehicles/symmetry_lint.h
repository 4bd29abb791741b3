#pragma once

#include "vehicles/lint_subject.h"

namespace fourpost {

/// Elements named as left and right whose points are nearly, but not quite, mirror images at y = 0. Sensors are left
/// out: they sit where there is room.
void LintMirroredPoints(const LintSubject& subject, FileFaults& findings);

/// Elements named as left and right with numbers that differ by a factor of ten or more.
void LintMirroredNumbers(const LintSubject& subject, FileFaults& findings);

/// Anti-roll bars whose two lines are on one side of the car.
void LintBarSides(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
