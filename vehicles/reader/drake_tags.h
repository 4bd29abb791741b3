#pragma once

#include <string>

#include <tinyxml2.h>

#include "vehicles/description/vehicle.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Replaces tags of Drake's dialect of URDF, directly below `<robot>`, by `fp:` tags:
///   <frame>                       fp:frame
///   <drake:linear_spring_damper>  fp:spring and fp:damper between two fp:frame
///   <drake:ball_constraint>       fp:ball between two fp:frame
///   <drake:linear_bushing_rpy>    fp:bushing
/// Drake's numbers are SI and have no units. Elements that Drake leaves without a name get a unique one. Reports
/// children that are missing or unknown, and numbers that Drake would refuse; a tag with an error is left out. Returns
/// true if anything was replaced. Source: Drake's documentation of its URDF extensions.
bool ReplaceDrakeTags(tinyxml2::XMLElement& robot, FileFaults& faults);

/// The tags with Drake's prefix that are replaced: "ball_constraint, ... and ...".
std::string DrakeTagNames();

/// Warns of each bushing of Drake's whose two frames do not coincide in the design pose, as written: Drake's is loaded
/// there, fp:bushing is not. `robot`: after ReplaceDrakeTags.
void CheckDrakeBushings(const tinyxml2::XMLElement& robot, const Vehicle& vehicle, FileFaults& faults);

}  // namespace fourpost
