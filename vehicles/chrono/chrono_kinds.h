#pragma once

#include "vehicles/templates/suspension_kind.h"

namespace fourpost {

/// A kind of docs/suspensions.md, or one that only Chrono has: a beam axle that moves along fixed directions of the
/// chassis, without links.
///   guided_axle: up and down, and turns about its middle (LeafspringAxle)
///   guided_panhard: in the plane across the car, with a Panhard rod (RigidPanhardAxle)
/// nullptr for an unknown name.
const SuspensionKind* FindChronoKind(std::string_view name);

}  // namespace fourpost
