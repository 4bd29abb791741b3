#pragma once

#include "vehicles/description/vehicle.h"
#include "vehicles/reader/parameter_reader.h"
#include "vehicles/reader/urdf_tree.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Reads the elements of the `fp:` tags, parameters excepted, into the vehicle.
void ReadElements(const tinyxml2::XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters,
                  Vehicle& vehicle, FileFaults& faults);

}  // namespace fourpost
