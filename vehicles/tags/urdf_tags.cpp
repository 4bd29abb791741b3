#include "vehicles/tags/tag_table.h"

namespace fourpost {
namespace {

using Kind = AttributeKind;

AttributeRule Optional(std::string_view name, Kind kind) { return {.name = name, .kind = kind, .required = false}; }

AttributeRule Number(std::string_view name, Sign sign = Sign::kAny) {
  return {.name = name, .kind = Kind::kNumber, .sign = sign};
}

TagRule Origin(std::string_view path) {
  return {.path = path,
          .occurs = Occurs::kAtMostOnce,
          .attributes = {Optional("xyz", Kind::kVector), Optional("rpy", Kind::kVector)}};
}

TagRule Opaque(std::string_view path, Occurs occurs = Occurs::kAny) {
  return {.path = path, .occurs = occurs, .opaque = true};
}

TagRule Only(std::string_view path, std::string_view attribute) {
  return {.path = path, .occurs = Occurs::kOnce, .attributes = {{.name = attribute}}};
}

std::vector<TagRule> MakeLinkTags() {
  return {
      {.path = "link", .attributes = {{.name = "name"}, Optional("type", Kind::kText)}},
      {.path = "link/inertial", .occurs = Occurs::kAtMostOnce},
      Origin("link/inertial/origin"),
      {.path = "link/inertial/mass",
       .occurs = Occurs::kOnce,
       .attributes = {{.name = "value",
                       .kind = Kind::kNumber,
                       .dimension = kMass,
                       .sign = Sign::kNotNegative,
                       .usual_least = "1 g",
                       .usual_greatest = "100 t"}}},
      {.path = "link/inertial/inertia",
       .occurs = Occurs::kOnce,
       .attributes = {Number("ixx", Sign::kNotNegative), Number("ixy"), Number("ixz"),
                      Number("iyy", Sign::kNotNegative), Number("iyz"), Number("izz", Sign::kNotNegative)}},
      {.path = "link/visual", .attributes = {Optional("name", Kind::kText)}},
      Origin("link/visual/origin"),
      Opaque("link/visual/material", Occurs::kAtMostOnce),
      {.path = "link/visual/geometry", .occurs = Occurs::kOnce},
      {.path = "link/visual/geometry/mesh",
       .occurs = Occurs::kOneOfAll,
       .attributes = {{.name = "filename"},
                      {.name = "scale", .kind = Kind::kDirection, .doc = "metres per unit of the mesh file"}}},
      {.path = "link/visual/geometry/box",
       .occurs = Occurs::kOneOfAll,
       .attributes = {{.name = "size", .kind = Kind::kVector}}},
      {.path = "link/visual/geometry/cylinder",
       .occurs = Occurs::kOneOfAll,
       .attributes = {Number("radius", Sign::kPositive), Number("length", Sign::kPositive)}},
      {.path = "link/visual/geometry/sphere",
       .occurs = Occurs::kOneOfAll,
       .attributes = {Number("radius", Sign::kPositive)}},
      Opaque("link/collision"),
  };
}

std::vector<TagRule> MakeJointTags() {
  return {
      {.path = "joint",
       .attributes = {{.name = "name"},
                      {.name = "type",
                       .kind = Kind::kChoice,
                       .choices = {"fixed", "revolute", "continuous", "prismatic", "planar", "floating"}}}},
      Origin("joint/origin"),
      Only("joint/parent", "link"),
      Only("joint/child", "link"),
      {.path = "joint/axis", .occurs = Occurs::kAtMostOnce, .attributes = {{.name = "xyz", .kind = Kind::kDirection}}},
      {.path = "joint/limit",
       .occurs = Occurs::kAtMostOnce,
       .attributes = {Optional("lower", Kind::kNumber), Optional("upper", Kind::kNumber), Number("effort"),
                      Number("velocity")}},
      Opaque("joint/dynamics"),
      Opaque("joint/calibration"),
      Opaque("joint/mimic"),
      Opaque("joint/safety_controller"),
      Opaque("material"),
      Opaque("transmission"),
      Opaque("gazebo"),
  };
}

std::vector<TagRule> MakeUrdfTags() {
  std::vector<TagRule> tags = MakeLinkTags();
  for (TagRule& tag : MakeJointTags()) tags.push_back(std::move(tag));
  return tags;
}

}  // namespace

std::span<const TagRule> UrdfTags() {
  static const std::vector<TagRule> tags = MakeUrdfTags();
  return tags;
}

}  // namespace fourpost
