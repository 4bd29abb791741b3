#pragma once

#include <tinyxml2.h>

#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Adds what `<fp:mirror from="_left" to="_right"/>` asks for: behind each link, joint and tag of ours whose name ends
/// in `from` its twin, whose name ends in `to`, mirrored at the plane y = 0 of the axes in which its numbers stand.
///
/// With M = diag(1, -1, 1), as x' = M x, R' = M R M, I' = M I M:
///   xyz, axis (polar: position, direction of motion or force)    (x, -y, z)
///   axis of a revolute joint, hinge or gyro (axial: turning)     (-x, y, -z)
///   rpy                                                          (-r, p, -y)
///   inertia                                                      ixy and iyz change sign
///   scale of a mesh                                              (x, -y, z)
/// so that equal coordinates of a joint and its twin are mirror images. References to a mirrored name become references
/// to its twin, and back. `<fp:solid>`, without a name, goes by its link. A number that follows a parameter has a twin
/// that follows it too. A twin whose name a tag of its kind has already is not made, nor that of an anti-roll bar whose
/// two lines are each other's mirror images: the twin would be the same bar.
///
/// The tags must have been checked; reports mirrors without effect or given twice, binds to numbers of twins, and bars
/// that stay single under a mirrored name. Returns the names of the twins; none: nothing is added.
TwinNames AddTwins(tinyxml2::XMLElement& robot, FileFaults& faults);

}  // namespace fourpost
