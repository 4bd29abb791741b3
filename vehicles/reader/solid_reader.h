#pragma once

#include "vehicles/description/vehicle.h"
#include "vehicles/reader/parameter_reader.h"
#include "vehicles/reader/urdf_tree.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Reads every `<fp:solid>` and gives its link mass, centre of mass and inertia from the link's visual shapes. With a
/// density that is a parameter, mass and inertia follow it. A vehicle without links has its tags checked all the same.
/// Returns false, with faults, when a link has not got its mass.
bool ReadSolids(const tinyxml2::XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters, Vehicle& vehicle,
                FileFaults& faults);

}  // namespace fourpost
