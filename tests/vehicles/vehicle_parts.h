#pragma once

#include <string>

namespace fourpost {

// Texts of what small vehicles are made of.

/// A link whose mass [kg] is in its origin.
inline std::string PointMass(const std::string& link, const std::string& mass) {
  return R"(  <link name=")" + link + R"("><inertial><mass value=")" + mass + R"("/>
    <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
)";
}

/// A joint that slides along an axis, upright where none is given, from its origin in the parent [m].
inline std::string PrismaticJoint(const std::string& name, const std::string& parent, const std::string& child,
                                  const std::string& origin, const std::string& axis = "0 0 1") {
  return R"(  <joint name=")" + name + R"(" type="prismatic"><parent link=")" + parent + R"("/><child link=")" + child +
         R"("/>
    <origin xyz=")" +
         origin + R"("/><axis xyz=")" + axis + R"("/><limit effort="0" velocity="0"/></joint>
)";
}

}  // namespace fourpost
