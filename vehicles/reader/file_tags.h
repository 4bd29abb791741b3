#pragma once

#include <tinyxml2.h>

#include "vehicles/description/vehicle.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Gives tags with an attribute `file` what that file holds, as if it were written out: points to the `<table>` of a
/// spring or damper, rates to a bushing, each but those that it states itself. Reports files that are missing or
/// faulty, and tables with points of their own. Returns what was taken.
std::vector<FileContent> FillFileTags(tinyxml2::XMLElement& robot, FileFaults& faults);

/// Places springs on curves whose file states a free length, where they have no `at`: at their length in the design
/// pose. Reports guided ones, which have none, and those that stand beyond the ends of their curve.
void PlaceOnCurves(Vehicle& vehicle, FileFaults& faults);

/// The content of Vehicle::contents for an element of a vehicle file; nullptr where it has none.
const FileContent* ContentOf(const Vehicle& vehicle, const tinyxml2::XMLElement& element);

}  // namespace fourpost
