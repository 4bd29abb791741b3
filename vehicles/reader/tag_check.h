#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// The XML namespace of the `fp:` tags.
inline constexpr const char* kNamespace = "urn:fourpost:vehicle:1";

/// Checks every tag and attribute against the table of tags: known, present, legal count, legal plain numbers, unique
/// names. Warns about each foreign prefix once.
void CheckTags(const tinyxml2::XMLElement& robot, FileFaults& faults);

/// Checks the attributes of one element against its rule.
void CheckAttributes(const tinyxml2::XMLElement& element, const TagRule& rule, FileFaults& faults);

/// Whether the element at this path has a child that CheckTags reports as unknown.
bool HasUnknownTag(const tinyxml2::XMLElement& element, std::string_view path);

/// Whether a child of `<robot>` is unknown to the `fp:` tags and to URDF, so that CheckTags reports it.
bool IsUnknownTag(const tinyxml2::XMLElement& element);

/// Names that children of `<robot>` lack through an error of their own: their tag is unknown, or their attribute `name`
/// is misspelt. References to such a name are not reported.
std::set<std::string, std::less<>> LostNames(const tinyxml2::XMLElement& robot);

/// End of a message about an unknown name: the nearest legal one, or else all of them.
std::string SuggestLegal(std::string_view name, const std::vector<std::string_view>& legal);

}  // namespace fourpost
