#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/text/units.h"

namespace fourpost {

/// Kinds of attributes, by their legal text.
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
  /// An earlier spelling, which is read with a warning; empty: none.
  std::string_view former = {};
  /// Used if an optional attribute is missing; empty: none.
  std::string_view fallback = {};
  std::string_view doc = {};
  Dimension dimension = kDimensionless;
  Sign sign = Sign::kAny;
  /// A word in place of a number, such as "equilibrium".
  std::string_view word = {};
  std::vector<std::string_view> choices = {};
  /// Usual range of a nonzero number on road vehicles, with a margin, as "1 kN/m"; empty: no bound.
  std::string_view usual_least = {};
  std::string_view usual_greatest = {};
};

/// How often a tag may occur under its parent.
enum class Occurs { kAny, kAtMostOnce, kOnce, kOneOfAll };

/// One tag that a vehicle file may contain.
struct TagRule {
  /// Tags from below `<robot>` down: "link/inertial/mass".
  std::string_view path;
  /// Distinguishes the forms of one tag by their attribute `type`; empty: the tag has one form.
  std::string_view type = {};
  /// kOneOfAll: just one of the parent's tags with this mark.
  Occurs occurs = Occurs::kAny;
  /// Content that the reader does not use; always legal.
  bool opaque = false;
  std::string_view doc = {};
  std::vector<AttributeRule> attributes = {};

  /// "mass" of "link/inertial/mass".
  std::string_view Name() const;
};

/// The `fp:` tags and those of URDF.
std::span<const TagRule> OwnTags();
std::span<const TagRule> UrdfTags();

/// The forms of the tag with this path, `fp:` or URDF; empty for an unknown tag.
std::vector<const TagRule*> FindTags(std::string_view path);

/// The tags below this path ("" for those directly below `<robot>`), each form of its own.
std::vector<const TagRule*> TagsBelow(std::string_view path);

/// The rule of the attribute of this name, or of this earlier spelling; nullptr if the tag has none.
const AttributeRule* FindAttribute(const TagRule& tag, std::string_view name);

/// The reference of the `fp:` tags, in Markdown: part of `urdf/README.md`.
std::string TagReference();

}  // namespace fourpost
