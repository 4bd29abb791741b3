#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>
#include <Eigen/Core>

#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// Line of the element in the file; for an element that an expansion made, of the one it was made from.
int LineOf(const tinyxml2::XMLElement& element);

/// Line of the attribute; of the element when it is left out.
int LineOf(const tinyxml2::XMLElement& element, std::string_view attribute);

/// The element of the file from which this one was made, step by step; itself when it stands there.
const tinyxml2::XMLElement& Written(const tinyxml2::XMLElement& element);

/// Whether an expansion made the element, so that it does not stand in the file.
bool IsMade(const tinyxml2::XMLElement& element);

/// Notes that `made` was made from `origin`, which must live as long.
void SetOrigin(tinyxml2::XMLElement& made, tinyxml2::XMLElement& origin);

/// A copy of the element with all that it holds, made from it and not yet placed; its document owns it.
tinyxml2::XMLElement& CopyOf(tinyxml2::XMLElement& element);

/// An element of a vehicle file with the rule for its form.
struct Tag {
  const tinyxml2::XMLElement* element = nullptr;
  const TagRule* rule = nullptr;

  int Line() const { return LineOf(*element); }
  int Line(std::string_view attribute) const { return LineOf(*element, attribute); }
  /// The attribute's text or its fallback; empty when there is neither.
  std::string Text(std::string_view attribute) const;
};

/// The element's attribute; nothing when it is left out.
std::optional<std::string> AttributeText(const tinyxml2::XMLElement& element, std::string_view attribute);

/// The rule for an element with this path; nullptr for an unknown tag or form.
const TagRule* FormOf(const tinyxml2::XMLElement& element, std::string_view path);

/// Child elements, all or those with this name.
std::vector<const tinyxml2::XMLElement*> Children(const tinyxml2::XMLElement& parent, const char* name = nullptr);
std::vector<tinyxml2::XMLElement*> Children(tinyxml2::XMLElement& parent, const char* name = nullptr);

/// The parent's tags of this path that have a legal form.
std::vector<Tag> TagsOf(const tinyxml2::XMLElement& parent, std::string_view path);

/// How messages call an element: "fp:spring 'coil'", "<mass> of link 'body'".
std::string Describe(const tinyxml2::XMLElement& element);

/// Three finite numbers separated by blanks, no more.
std::optional<Eigen::Vector3d> ParseVector(std::string_view text);

/// Without blanks at both ends.
std::string_view Trimmed(std::string_view text);

}  // namespace fourpost
