#pragma once

#include "vehicles/description/element_list.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// The rule of the attribute in which a vehicle file states this number.
const AttributeRule& RuleOf(const ElementNumber& number);

}  // namespace fourpost
