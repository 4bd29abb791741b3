#pragma once

#include "analysis/text/diagnostics.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// An error for each way in which loop closures lock a vehicle, with the closures that cause it and the motion that is
/// lost. A multibody system accepts such a lock silently and carries any force. Errors are:
///   - links that cannot move against each other though neither a fixed joint nor an fp:weld joins them;
///   - a wheel or an axle that has lost a vertical motion of its tyres against the body: a beam axle that cannot roll;
///     an fp:hinge or an fp:weld that does so alone is considered intended;
///   - a singular pose, see DeadCentres: the hop of an axle that two ball joints and a horizontal Panhard rod hold
///     sideways.
/// Leaves the multibody in the design pose.
Diagnostics LoopLocks(Multibody& multibody);

/// The findings of LoopLocks; if there are none, that dependent closures cannot follow a motion.
FaultyInput LoopsCannotFollow(Multibody& multibody);

}  // namespace fourpost
