#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// Letters, digits, '_', '-' and '.'.
bool IsNameCharacter(char c);

/// Checks a text against its rule as far as that can be done without the rest of the file: names, plain numbers,
/// vectors and choices.
void CheckAttribute(const tinyxml2::XMLElement& element, const AttributeRule& rule, const std::string& text, int line,
                    FileFaults& faults);

/// What belongs into an attribute that is missing, to end a message with: ", a stiffness such as "1 N/m"".
std::string Expectation(const AttributeRule& rule);

/// "a stiffness", "an inertia", "a pure number".
std::string WithArticle(const Dimension& dimension);
/// "stiffnesses", "inertias"; of a dimension without a name "in kg*m".
std::string Plural(const Dimension& dimension);

/// No number of a vehicle, in SI, is larger than this, nor one that must be above zero smaller than its inverse.
/// Products of several stay within a double, so that nothing behind the reader overflows or divides by zero.
inline constexpr double kLargestNumber = 1e30;

/// What is wrong with a number that may take every value from `least` to `greatest`; empty: nothing.
std::string RangeFault(double least, double greatest, Sign sign);

/// "a, b, c".
std::string Joined(const std::vector<std::string_view>& names);

}  // namespace fourpost
