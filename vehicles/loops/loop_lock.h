#pragma once

#include "analysis/diagnostics.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// An error, with the closures that do it and the motion that is lost, for each way in which loop closures lock a
/// vehicle, as a multibody system carries without a word, with any force:
///   - links that cannot move against each other though neither a fixed joint nor an fp:weld makes them one;
///   - a wheel or an axle that has lost a vertical motion of its tyres against the body: a beam axle that cannot roll;
///     an fp:hinge or an fp:weld that does so alone is taken to mean it;
///   - a motion that the closures let begin but not go on, see DeadCentres: the hop of an axle that two ball joints and
///     a horizontal Panhard rod hold sideways.
/// Leaves the multibody in the design pose.
Diagnostics LoopLocks(Multibody& multibody);

/// What LoopLocks finds, or, where it finds nothing, that closures which depend on each other cannot follow a motion.
FaultyInput LoopsCannotFollow(Multibody& multibody);

}  // namespace fourpost
