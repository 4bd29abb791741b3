#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/units.h"

namespace fourpost {

/// What the text of an attribute must be.
enum class AttributeKind {
  kText,
  /// A name that others refer to; letters, digits, '_', '.' and '-'.
  kName,
  /// The name of a link, a frame or link, a tyre, or of a number of the tree.
  kLink,
  kPoint,
  kTyre,
  kTreeNumber,
  /// A plain number without unit.
  kNumber,
  /// Three plain numbers; of a direction not all zero.
  kVector,
  kDirection,
  /// A number with a unit of any dimension.
  kQuantity,
  /// A number with a unit of the rule's dimension, or a parameter: "$k", "-$k", "0.5*$k".
  kScalar,
  /// One of the rule's choices.
  kChoice,
};

/// The numbers that are legal.
enum class Sign { kAny, kNotNegative, kPositive };

struct AttributeRule {
  std::string_view name;
  AttributeKind kind = AttributeKind::kText;
  bool required = true;
  /// Used when an optional attribute is left out; empty: none.
  std::string_view fallback = {};
  std::string_view doc = {};
  Dimension dimension = kDimensionless;
  Sign sign = Sign::kAny;
  /// A word that stands for a number, such as "equilibrium".
  std::string_view word = {};
  std::vector<std::string_view> choices = {};
  /// Where the size of a number other than zero lies on road vehicles, with room to spare, as "1 kN/m"; empty: no
  /// bound.
  std::string_view usual_least = {};
  std::string_view usual_greatest = {};
};

/// How often a tag may stand under its parent.
enum class Occurs { kAny, kAtMostOnce, kOnce, kOneOfAll };

/// One tag that a vehicle file may contain.
struct TagRule {
  /// Tags from below `<robot>` down: "link/inertial/mass".
  std::string_view path;
  /// Tells the forms of one tag apart by their attribute `type`; empty: the tag has one form.
  std::string_view type = {};
  /// kOneOfAll: just one of the parent's tags with this mark.
  Occurs occurs = Occurs::kAny;
  /// Content that the reader does not use, legal whatever it is.
  bool opaque = false;
  std::string_view doc = {};
  std::vector<AttributeRule> attributes = {};

  /// "mass" of "link/inertial/mass".
  std::string_view Name() const;
};

/// The tags of our own and those of URDF.
std::span<const TagRule> OwnTags();
std::span<const TagRule> UrdfTags();

/// The forms of the tag with this path, own or URDF; empty for an unknown tag.
std::vector<const TagRule*> FindTags(std::string_view path);

/// The tags below this path ("" for those directly below `<robot>`), each form of its own.
std::vector<const TagRule*> TagsBelow(std::string_view path);

/// The attribute's rule; nullptr when the tag has none of that name.
const AttributeRule* FindAttribute(const TagRule& tag, std::string_view name);

/// The reference of our own tags, in Markdown: what `urdf/README.md` shows.
std::string TagReference();

}  // namespace fourpost
