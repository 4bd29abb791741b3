#pragma once

#include <cstddef>
#include <vector>

#include "identify/search/population.h"

namespace fourpost {

/// The best distinct points of those that were added.
class Elites {
 public:
  explicit Elites(std::size_t most) : most_(most) {}

  void Add(const Individual& individual);
  void Clear() { best_.clear(); }

  /// Best first.
  const Population& best() const { return best_; }

 private:
  std::size_t most_;
  Population best_;
};

}  // namespace fourpost
