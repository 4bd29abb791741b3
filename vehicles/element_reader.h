#pragma once

#include "vehicles/file_faults.h"
#include "vehicles/parameter_reader.h"
#include "vehicles/urdf_tree.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// Reads what the tags of our own describe, but parameters, into the vehicle.
void ReadElements(const tinyxml2::XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters,
                  Vehicle& vehicle, FileFaults& faults);

}  // namespace fourpost
