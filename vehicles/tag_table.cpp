#include "vehicles/tag_table.h"

#include <algorithm>

namespace fourpost {
namespace {

using Kind = AttributeKind;

const AttributeRule kNameRule = {.name = "name", .kind = Kind::kName, .doc = "unique among tags of its kind"};
const AttributeRule kLinkRule = {.name = "link", .kind = Kind::kLink, .doc = "link that carries the point"};
const AttributeRule kXyzRule = {.name = "xyz", .kind = Kind::kVector, .doc = "the point in link axes, in m"};
const AttributeRule kParentRule = {.name = "parent", .kind = Kind::kPoint, .doc = "frame or link at one end"};
const AttributeRule kChildRule = {.name = "child", .kind = Kind::kPoint, .doc = "frame or link at the other end"};
const AttributeRule kGuideRule = {.name = "axis",
                                  .kind = Kind::kDirection,
                                  .required = false,
                                  .doc =
                                      "direction of a guided strut in axes of the parent's link; without it the "
                                      "element acts along the line that joins its ends"};
const AttributeRule kSensorAxisRule = {.name = "axis",
                                       .kind = Kind::kDirection,
                                       .required = false,
                                       .fallback = "0 0 1",
                                       .doc = "measuring direction in link axes"};

AttributeRule SensorType(std::string_view type) {
  return {.name = "type", .kind = Kind::kChoice, .doc = "kind of sensor", .choices = {type}};
}

AttributeRule Stiffness(std::string_view doc, Sign sign = Sign::kNotNegative) {
  return {.name = "stiffness", .kind = Kind::kScalar, .doc = doc, .dimension = kStiffness, .sign = sign};
}

AttributeRule Rate(std::string_view name, std::string_view doc) {
  return {.name = name, .kind = Kind::kScalar, .doc = doc, .dimension = kDamping, .sign = Sign::kNotNegative};
}

AttributeRule Preload(std::string_view doc) {
  return {.name = "preload",
          .kind = Kind::kScalar,
          .required = false,
          .fallback = "equilibrium",
          .doc = doc,
          .dimension = kForce,
          .word = "equilibrium"};
}

AttributeRule Bound(std::string_view name, std::string_view doc) {
  return {.name = name, .kind = Kind::kQuantity, .required = false, .doc = doc};
}

std::vector<TagRule> MakeParameterTags() {
  return {
      {.path = "fp:parameter",
       .doc = "A number that a fit may change, used as `$name` or bound to numbers of the tree. Without bounds it is "
              "fixed; give all three of lower, upper and precision or none.",
       .attributes = {{.name = "name", .kind = Kind::kName, .doc = "letters, digits and '_'"},
                      {.name = "value", .kind = Kind::kQuantity, .doc = "the number, with the unit it is shown in"},
                      Bound("lower", "least value of a search"),
                      Bound("upper", "greatest value of a search"),
                      Bound("precision", "step of a search, above zero and at most upper - lower"),
                      {.name = "source", .doc = "where the value comes from"}}},
      {.path = "fp:parameter/fp:bind",
       .doc = "Ties a number of the tree to the parameter. The tree's number must equal factor times value.",
       .attributes = {{.name = "to",
                       .kind = Kind::kTreeNumber,
                       .doc = "`link[NAME]/mass` or `link[NAME]/inertia/ixx` (iyy, izz, ixy, ixz, iyz)"},
                      {.name = "factor",
                       .kind = Kind::kNumber,
                       .required = false,
                       .fallback = "1",
                       .doc = "the tree's number over the parameter"}}},
      {.path = "fp:frame", .doc = "A named point of a link.", .attributes = {kNameRule, kLinkRule, kXyzRule}},
  };
}

std::vector<TagRule> MakeForceTags() {
  return {
      {.path = "fp:spring",
       .doc = "A spring between two points.",
       .attributes = {kNameRule, kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:spring/linear",
       .occurs = Occurs::kOneOfAll,
       .doc = "tension = preload + stiffness (L - L_design)",
       .attributes = {Stiffness("force per extension"),
                      Preload("tension in the design pose; `equilibrium`: whatever holds that pose at rest")}},
      {.path = "fp:damper",
       .doc = "A damper between two points. Rebound is extension and pulls the points together.",
       .attributes = {kNameRule, kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:damper/linear",
       .occurs = Occurs::kOneOfAll,
       .doc = "f = rate v",
       .attributes = {Rate("rate", "force per speed")}},
      {.path = "fp:damper/bilinear",
       .occurs = Occurs::kOneOfAll,
       .doc = "f = rebound v in extension, compression v in compression",
       .attributes = {Rate("compression", "force per speed in bump"), Rate("rebound", "force per speed in rebound")}},
      {.path = "fp:damper/series",
       .occurs = Occurs::kAtMostOnce,
       .doc = "A spring in line with the damper, such as its top mount. The damper's rates must be above zero then.",
       .attributes = {Stiffness("force per deflection", Sign::kPositive)}},
      {.path = "fp:tyre",
       .doc = "A vertical spring and damper between a point of a link and the platform under it. Put the point at the "
              "wheel's "
              "centre where the link turns, as on an arm: a tyre stays upright, but a point at its foot would swing.",
       .attributes = {kNameRule,
                      kLinkRule,
                      kXyzRule,
                      Stiffness("force per deflection"),
                      {.name = "damping",
                       .kind = Kind::kScalar,
                       .required = false,
                       .fallback = "0 N*s/m",
                       .doc = "force per speed",
                       .dimension = kDamping,
                       .sign = Sign::kNotNegative},
                      Preload("compression force in the design pose; `equilibrium`: whatever holds it at rest")}},
      {.path = "fp:post",
       .doc = "A hydraulic post that drives the platform under a tyre; one a tyre at most.",
       .attributes = {kNameRule, {.name = "under", .kind = Kind::kTyre, .doc = "tyre that it drives"}}},
      {.path = "fp:rod",
       .doc = "Keeps two points at their distance in the design pose.",
       .attributes = {kNameRule, kParentRule, kChildRule}},
      {.path = "fp:ball", .doc = "Keeps two points together.", .attributes = {kNameRule, kParentRule, kChildRule}},
  };
}

std::vector<TagRule> MakeSensorTags() {
  return {
      {.path = "fp:sensor",
       .type = "accelerometer",
       .doc = "Acceleration of a point along an axis fixed in its link, zero at rest.",
       .attributes = {kNameRule, SensorType("accelerometer"), kLinkRule, kXyzRule, kSensorAxisRule}},
      {.path = "fp:sensor",
       .type = "displacement",
       .doc = "Displacement of a point from the design pose, along an axis fixed in space.",
       .attributes = {kNameRule, SensorType("displacement"), kLinkRule, kXyzRule, kSensorAxisRule}},
      {.path = "fp:sensor",
       .type = "strut",
       .doc = "Extension of the distance between two points from the design pose.",
       .attributes = {kNameRule, SensorType("strut"), kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:sensor",
       .type = "load_cell",
       .doc = "Dynamic force of a tyre on its platform, more load positive.",
       .attributes = {kNameRule,
                      SensorType("load_cell"),
                      {.name = "tyre", .kind = Kind::kTyre, .doc = "tyre whose force is measured"}}},
  };
}

std::vector<TagRule> MakeOwnTags() {
  std::vector<TagRule> tags;
  for (auto* make : {MakeParameterTags, MakeForceTags, MakeSensorTags})
    for (TagRule& tag : make()) tags.push_back(std::move(tag));
  return tags;
}

void AddWhere(std::span<const TagRule> tags, bool (*matches)(std::string_view, std::string_view), std::string_view path,
              std::vector<const TagRule*>& found) {
  for (const TagRule& tag : tags)
    if (matches(tag.path, path)) found.push_back(&tag);
}

std::vector<const TagRule*> Collect(bool (*matches)(std::string_view, std::string_view), std::string_view path) {
  std::vector<const TagRule*> found;
  AddWhere(OwnTags(), matches, path, found);
  AddWhere(UrdfTags(), matches, path, found);
  return found;
}

bool IsBelow(std::string_view tag, std::string_view parent) {
  const std::size_t slash = tag.rfind('/');
  return (slash == std::string_view::npos ? std::string_view() : tag.substr(0, slash)) == parent;
}

}  // namespace

std::string_view TagRule::Name() const { return path.substr(path.rfind('/') + 1); }

std::span<const TagRule> OwnTags() {
  static const std::vector<TagRule> tags = MakeOwnTags();
  return tags;
}

std::vector<const TagRule*> FindTags(std::string_view path) {
  return Collect([](std::string_view tag, std::string_view wanted) { return tag == wanted; }, path);
}

std::vector<const TagRule*> TagsBelow(std::string_view path) { return Collect(IsBelow, path); }

const AttributeRule* FindAttribute(const TagRule& tag, std::string_view name) {
  const auto found = std::find_if(tag.attributes.begin(), tag.attributes.end(),
                                  [&](const AttributeRule& attribute) { return attribute.name == name; });
  return found == tag.attributes.end() ? nullptr : &*found;
}

}  // namespace fourpost
