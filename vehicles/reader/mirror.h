#pragma once

#include <tinyxml2.h>

#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Expands `<fp:mirror from="_left" to="_right"/>`: adds after each link, joint and `fp:` tag whose name ends in `from`
/// its mirror partner, whose name ends in `to`, mirrored at the plane y = 0 of the axes in which its numbers are given.
///
/// With M = diag(1, -1, 1), as x' = M x, R' = M R M, I' = M I M:
///   xyz, axis (polar: position, direction of motion or force)    (x, -y, z)
///   axis of a revolute joint, hinge or gyro (axial: turning)     (-x, y, -z)
///   rpy                                                          (-r, p, -y)
///   inertia                                                      ixy and iyz change sign
///   scale of a mesh                                              (x, -y, z)
/// so that equal coordinates of a joint and its partner are mirror images. References to a mirrored name become
/// references to its partner, and vice versa. `<fp:solid>`, without a name, follows its link. If a number follows a
/// parameter, so does that of its partner. No partner is made if a tag of its kind already has that name, nor for an
/// anti-roll bar whose two lines are each other's mirror images: the partner would be the same bar.
///
/// The tags must have been checked. Reports mirrors without effect or given twice, binds to numbers of partners, and
/// bars that stay single under a mirrored name. Returns the names of the partners; empty: nothing was added.
TwinNames AddTwins(tinyxml2::XMLElement& robot, FileFaults& faults);

}  // namespace fourpost
