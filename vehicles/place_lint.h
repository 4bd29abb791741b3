#pragma once

#include "vehicles/lint_subject.h"

namespace fourpost {

/// Accelerometers and displacement sensors far off everything else.
void LintSensorPlaces(const LintSubject& subject, FileFaults& findings);

/// Tyres that do not stand on the platform's height, z = 0.
void LintTyreHeights(const LintSubject& subject, FileFaults& findings);

/// Springs and dampers between points that are hardly apart, or too far.
void LintLengths(const LintSubject& subject, FileFaults& findings);

/// Tyres without a post.
void LintPosts(const LintSubject& subject, FileFaults& findings);

/// A vehicle without a sensor.
void LintSensors(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
