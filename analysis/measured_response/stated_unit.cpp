#include "analysis/measured_response/stated_unit.h"

namespace fourpost {
namespace {

/// '*' is any text.
bool Matches(std::string_view name, std::string_view pattern) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() != '*')
    return !name.empty() && name.front() == pattern.front() && Matches(name.substr(1), pattern.substr(1));
  return Matches(name, pattern.substr(1)) || (!name.empty() && Matches(name.substr(1), pattern));
}

}  // namespace

bool StatedUnit::Names(std::string_view name) const { return Matches(name, channel); }

std::string UnitStatedOf(const std::vector<StatedUnit>& units, std::string_view name) {
  std::string unit;
  for (const StatedUnit& stated : units)
    if (stated.Names(name)) unit = stated.unit;
  return unit;
}

}  // namespace fourpost
