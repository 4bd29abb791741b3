#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "analysis/units.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// What stands for a parameter: "$k", "-$k", "0.5*$k".
struct ParameterReference {
  double factor = 1;
  std::string_view name;
};

/// Nothing for any other text.
std::optional<ParameterReference> ParseReference(std::string_view text);

/// The reference that a text would be with the '$' that it lacks: "k", "0.5*k".
std::optional<ParameterReference> ReferenceWithoutDollar(std::string_view text);

/// A place of a vehicle file that needs a parameter, rightly written or not.
struct ParameterUse {
  std::string parameter;
  /// Of the number that belongs there; nothing where that is not known for a fault.
  std::optional<Dimension> dimension;
  /// Of the parameter times `factor`, which is that number; kAny where it is not known.
  Sign sign = Sign::kAny;
  double factor = 1;
  int line = 0;
  /// What it is the number of: "stiffness of <linear> of fp:spring 'coil'", or the path of an `<fp:bind>`.
  std::string what;
};

/// Every use that stands in the file: references in attributes, also of unknown tags, and `<fp:bind>`.
std::vector<ParameterUse> FindParameterUses(const tinyxml2::XMLElement& robot);

/// The same of a vehicle file's text, which must be XML.
std::vector<ParameterUse> FindParameterUses(const std::string& text);

}  // namespace fourpost
