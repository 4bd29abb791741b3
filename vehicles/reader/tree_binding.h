#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/reader/parameter_reader.h"
#include "vehicles/reader/urdf_tree.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// A number of the tree that follows a parameter.
struct TreeBinding {
  /// Index in UrdfTree::links.
  int link = -1;
  /// 0 for the mass, 1 to 6 for Link::inertia, 7 to 9 for Link::com.
  int number = 0;
  Scalar scalar;
};

/// Attributes of `<inertia>` in the order of Link::inertia.
inline constexpr const char* kInertiaNames[] = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};

/// Dimension of the number at a path such as "link[body]/mass"; empty for a path that no number can have.
std::optional<Dimension> DimensionOfPath(std::string_view path);

/// Sign of that number: no mass and no moment of inertia about an axis is negative.
Sign SignOfPath(std::string_view path);

/// Reads every `<fp:bind>`; reports invalid paths and numbers bound twice.
std::vector<TreeBinding> ReadTreeBindings(const tinyxml2::XMLElement& robot, const UrdfTree& tree,
                                          const ParameterReader& parameters, FileFaults& faults);

/// Binds the numbers of the vehicle's links to their parameters.
void Apply(const std::vector<TreeBinding>& bindings, Vehicle& vehicle);

}  // namespace fourpost
