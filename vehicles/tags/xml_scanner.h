#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace fourpost {

/// Position of an attribute's value in a text, without its quotes.
struct AttributePlace {
  std::string_view name;
  std::size_t begin = 0;
  std::size_t end = 0;
  /// The quote around it, ' or ".
  char quote = '"';
};

/// The attributes of one start tag.
struct TagPlaces {
  /// Position after the tag's name.
  std::size_t name_end = 0;
  std::vector<AttributePlace> attributes;
};

/// Finds the start tags of a well-formed XML text, in document order: the order in which a walk through the parsed
/// document meets its elements. Comments, declarations and CDATA are skipped.
std::vector<TagPlaces> ScanTags(std::string_view text);

}  // namespace fourpost
