#include "vehicles/lint/number_rule.h"

#include <stdexcept>

namespace fourpost {

const AttributeRule& RuleOf(const ElementNumber& number) {
  for (const TagRule* form : FindTags(number.tag))
    if (const AttributeRule* rule = FindAttribute(*form, number.attribute)) return *rule;
  throw std::logic_error("no tag " + number.tag + " has the attribute " + number.attribute);
}

}  // namespace fourpost
