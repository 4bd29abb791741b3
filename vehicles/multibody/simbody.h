#pragma once

// Single include for Simbody. Use it in sources of this room, never in a public header, and never write `using
// namespace SimTK` beside Eigen: SimTK has a catch-all operator!= that breaks Eigen's own comparisons.

#ifdef NDEBUG
#error "Debian's Simbody was built without NDEBUG; its inline State has another layout under NDEBUG and would crash"
#endif

#include <concepts>

namespace SimTK {

/// Comparison of Simbody's unique index types in C++20: `a == b` is ambiguous with its own reversed form unless an
/// exact match exists.
template <typename I>
concept UniqueIndex = requires(I index) {
  index.next();
  index.isValidExtended();
};
template <UniqueIndex I>
constexpr bool operator==(I a, I b) {
  return int{a} == int{b};
}

}  // namespace SimTK

// Not used here, and its iterators do not compile as C++20 with clang 14.
#define SimTK_SIMMATH_MULTIBODY_GRAPH_MAKER_H_
#include <Simbody.h>
