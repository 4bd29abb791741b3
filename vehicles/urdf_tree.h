#pragma once

#include <string>
#include <vector>

#include <tinyxml2.h>

#include "vehicles/file_faults.h"

namespace fourpost {

/// The links and joints of a file in the order of Vehicle.
struct UrdfTree {
  /// The ground first.
  std::vector<const tinyxml2::XMLElement*> links;
  /// Parents before children.
  std::vector<const tinyxml2::XMLElement*> joints;

  std::vector<std::string> LinkNames() const;
  /// Position of the link with this name; -1 when there is none.
  int FindLink(std::string_view name) const;
};

/// Orders links and joints; reports joints to unknown links, links with two parents, loops and all roots but one.
UrdfTree ReadUrdfTree(const tinyxml2::XMLElement& robot, FileFaults& faults);

}  // namespace fourpost
