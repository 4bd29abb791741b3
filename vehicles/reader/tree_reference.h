#pragma once

#include <string>
#include <string_view>

#include <tinyxml2.h>

#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Numbers of the tree that name a parameter, such as `<mass value="$m_body"/>`, `ixx="0.5*$I"` and `xyz="0 0 $z"` of
/// an `<inertial>`, so that their value is written once. Each becomes the number that the parameter gives, with an
/// `fp:bind` that ties it, which is generated from the element that the number stands in. Returns whether there was
/// one; `faults` may be null.
bool ReplaceTreeReferences(tinyxml2::XMLElement& robot, FileFaults* faults);

/// Whether a number of the tree names a parameter, well or badly.
bool HasReference(std::string_view text);

/// Whether an `fp:bind` stands for a reference in the tree.
bool IsTreeReference(const tinyxml2::XMLElement& bind);

/// `"0.5*$I" in <inertia> of ...` of such a bind, for messages.
std::string TreeReferenceText(const tinyxml2::XMLElement& bind);

}  // namespace fourpost
