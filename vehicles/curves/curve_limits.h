#pragma once

#include <cstddef>
#include <cstdint>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A curve of 1000 points has some 20 kB.
inline constexpr std::uintmax_t kMostCurve_MiB = 1;

/// Whether a file has so many faults that more say nothing, which ends its reading.
inline bool HasManyFaults(const Diagnostics& found) {
  constexpr std::size_t kMany = 100;
  return found.items().size() >= kMany;
}

}  // namespace fourpost
