#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace fourpost {

/// Checks a caller's argument: throws std::invalid_argument "place: needs a value for each of 2 posts, has 1" unless
/// the counts agree. `nouns` is a plural.
inline void RequireCount(const char* place, const char* nouns, std::size_t expected, std::size_t given) {
  if (given == expected) return;
  throw std::invalid_argument(std::string(place) + ": needs a value for each of " + std::to_string(expected) + " " +
                              nouns + ", has " + std::to_string(given));
}

}  // namespace fourpost
