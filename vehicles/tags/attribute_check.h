#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// Letters, digits, '_', '-' and '.'.
bool IsNameCharacter(char c);

/// Checks a text against its rule, as far as possible without the rest of the file: names, plain numbers, vectors and
/// choices.
void CheckAttribute(const tinyxml2::XMLElement& element, const AttributeRule& rule, const std::string& text, int line,
                    FileFaults& faults);

/// End of a message about a missing attribute, with its expected content: ", a stiffness such as "1 N/m"".
std::string Expectation(const AttributeRule& rule);

/// "a stiffness", "an inertia", "a pure number".
std::string WithArticle(const Dimension& dimension);
/// "stiffnesses", "inertias"; of a dimension without a name "in kg*m".
std::string Plural(const Dimension& dimension);

/// Limit of all numbers of a vehicle, in SI; numbers that must be above zero have its inverse as lower limit. Products
/// of several stay within a double, so that nothing after the reader overflows or divides by zero.
inline constexpr double kLargestNumber = 1e30;

/// The error of a number that may take every value from `least` to `greatest`; nullptr: none. Its words are the
/// attribute, and where the number follows a parameter " over the whole range of the parameter".
const Finding* RangeFault(double least, double greatest, Sign sign);

/// What most findings about an attribute begin with: `mass="2" of link 'body'`.
std::string Quoted(std::string_view attribute, const Tag& tag);

/// "a, b, c".
std::string Joined(const std::vector<std::string_view>& names);

}  // namespace fourpost
