#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// The links and joints of a file in the order of Vehicle.
struct UrdfTree {
  /// The ground first.
  std::vector<const tinyxml2::XMLElement*> links;
  /// Parents before children.
  std::vector<const tinyxml2::XMLElement*> joints;
  /// Indices of the links by their names.
  std::map<std::string, int, std::less<>> link_index;

  /// Stores the indices of the links.
  void IndexLinks();
  std::vector<std::string> LinkNames() const;
  /// ", did you mean 'body'?", the end of a message; empty if no name is near, or the message will not be shown.
  std::string LinkMeant(std::string_view name, const FileFaults& faults) const;
  /// Index of the link with this name; -1 if there is none.
  int FindLink(std::string_view name) const;
};

/// Limit of joint coordinates in a file: some seconds and some hundred megabytes, which grow with the fourth and the
/// third power. A car has some tens.
inline constexpr int kMostJointCoordinates = 200;

/// Orders links and joints; reports joints to unknown links, links with two parents, loops, more than one root, and too
/// many joint coordinates.
UrdfTree ReadUrdfTree(const tinyxml2::XMLElement& robot, FileFaults& faults);

}  // namespace fourpost
