#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fourpost {

/// The unit of channels of this name; '*' in it is any text.
struct StatedUnit {
  std::string channel;
  std::string unit;

  bool Names(std::string_view name) const;
};

/// Of the last that names the channel; empty: none does.
std::string UnitStatedOf(const std::vector<StatedUnit>& units, std::string_view name);

}  // namespace fourpost
