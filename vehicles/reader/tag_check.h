#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// The XML namespace of our tags.
inline constexpr const char* kNamespace = "urn:fourpost:vehicle:1";

/// Checks every tag and attribute against the table of tags: known, present, as often as legal, plain numbers legal;
/// and that no name is given twice. Foreign prefixes are warned about once each.
void CheckTags(const tinyxml2::XMLElement& robot, FileFaults& faults);

/// Checks the attributes of one element against its rule.
void CheckAttributes(const tinyxml2::XMLElement& element, const TagRule& rule, FileFaults& faults);

/// Whether the element, whose path this is, has a child that CheckTags reports as unknown.
bool HasUnknownTag(const tinyxml2::XMLElement& element, std::string_view path);

/// Whether a child of `<robot>` is none of the known tags, ours or URDF's, so that CheckTags reports it.
bool IsUnknownTag(const tinyxml2::XMLElement& element);

/// Names that children of `<robot>` lack by a fault of their own: their tag is unknown, or their attribute `name` is
/// misspelt. What refers to such a name is not at fault.
std::set<std::string, std::less<>> LostNames(const tinyxml2::XMLElement& robot);

/// To end a message about an unknown name with: the legal one that is near, or else all of them.
std::string Suggestion(std::string_view name, const std::vector<std::string_view>& legal);

}  // namespace fourpost
