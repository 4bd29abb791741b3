#pragma once

#include "vehicles/description/vehicle.h"
#include "vehicles/reader/parameter_reader.h"
#include "vehicles/reader/urdf_tree.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Reads every `<fp:solid>` and sets its link's mass, centre of mass and inertia from the link's visual shapes. If the
/// density is a parameter, mass and inertia follow it. The tags are checked even in a vehicle without links. Returns
/// false, with errors, if a link has no mass.
bool ReadSolids(const tinyxml2::XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters, Vehicle& vehicle,
                FileFaults& faults);

}  // namespace fourpost
