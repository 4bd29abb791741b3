#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "analysis/text/units.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// A reference to a parameter: "$k", "-$k", "0.5*$k".
struct ParameterReference {
  double factor = 1;
  std::string_view name;
};

/// Empty for any other text.
std::optional<ParameterReference> ParseReference(std::string_view text);

/// The reference that a text would be with the missing '$': "k", "0.5*k".
std::optional<ParameterReference> ReferenceWithoutDollar(std::string_view text);

/// A place of a vehicle file that needs a parameter, correctly written or not.
struct ParameterUse {
  std::string parameter;
  /// Dimension of the required number; empty if an error hides it.
  std::optional<Dimension> dimension;
  /// Sign of the parameter times `factor`, which is that number; kAny if unknown.
  Sign sign = Sign::kAny;
  double factor = 1;
  int line = 0;
  /// Meaning of the number: "stiffness of <linear> of fp:spring 'coil'", or the path of an `<fp:bind>`.
  std::string what;
};

/// Every use in the file: references in attributes, also of unknown tags, and `<fp:bind>`.
std::vector<ParameterUse> FindParameterUses(const tinyxml2::XMLElement& robot);

/// The same of a vehicle file's text, which must be XML.
std::vector<ParameterUse> FindParameterUses(const std::string& text);

}  // namespace fourpost
