#pragma once

#include <tinyxml2.h>

#include "vehicles/file_faults.h"

namespace fourpost {

/// The XML namespace of our tags.
inline constexpr const char* kNamespace = "urn:fourpost:vehicle:1";

/// Checks every tag and attribute against the table of tags: known, present, as often as legal, plain numbers legal;
/// and that no name is given twice. Foreign prefixes are warned about once each.
void CheckTags(const tinyxml2::XMLElement& robot, FileFaults& faults);

}  // namespace fourpost
