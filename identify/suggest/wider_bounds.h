#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fourpost {

/// A parameter at its "lower" or "upper" bound.
struct BoundReached {
  std::string parameter;
  std::string bound;
};

/// The vehicle file with those of these bounds ten times wider that a suggestion guessed; nothing where it guessed none
/// of them. A bound at 0 is no guess.
std::optional<std::string> WithWiderBounds(const std::string& vehicle, const std::vector<BoundReached>& reached);

}  // namespace fourpost
