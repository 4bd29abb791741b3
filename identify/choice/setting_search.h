#pragma once

#include <cstdint>
#include <vector>

#include "analysis/process/work_hooks.h"
#include "identify/choice/setting_table.h"

namespace fourpost {

/// More settings than this are searched.
inline constexpr std::int64_t kMostEnumerated = 100000;
/// Settings that are evaluated in all possible cars, at most.
inline constexpr std::size_t kMostDrawn = 1000;

/// Settings that are good at the fitted values.
struct PromisingSettings {
  /// At most kMostDrawn, the present one among them.
  std::vector<Setting> settings;
  std::int64_t evaluated = 0;
  bool was_searched = false;
  /// Some that were evaluated are not among them.
  bool was_cut = false;
  bool is_interrupted = false;
};

/// All settings, or on a lattice of more than `most_enumerated` those of a search by dvHDE with the seed of the
/// settings; of more than kMostDrawn the best ones, by limits first, in the order in which they stand on the lattice.
PromisingSettings FindPromising(const SettableCar& car, const std::vector<double>& fitted, int threads,
                                const WorkHooks& hooks, std::int64_t most_enumerated = kMostEnumerated);

}  // namespace fourpost
