#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fourpost {

/// What to end a message about an unknown name with: ", did you mean 'gain'?" where one is near; where none is, all of
/// few: "; it has a, b and c".
std::string KnownNames(std::string_view name, std::span<const std::string> known);

}  // namespace fourpost
