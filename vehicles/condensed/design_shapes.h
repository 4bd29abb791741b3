#pragma once

#include <functional>
#include <vector>

#include "vehicles/condensed/design_shape.h"
#include "vehicles/loops/chart.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// A scalar of the geometry in any pose.
using GeometricScalar = std::function<Coordinate(const Kinematics& pose)>;

/// Shapes of these scalars; second derivatives by central differences of the exact first ones. Leaves the multibody in
/// the design pose. Throws FaultyInput if the loops cannot follow a small motion.
std::vector<DesignShape> DesignShapes(Multibody& multibody, Chart& chart, const std::vector<GeometricScalar>& scalars);

}  // namespace fourpost
