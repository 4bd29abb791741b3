#include "identify/search/elites.h"

#include <algorithm>

namespace fourpost {

void Elites::Add(const Individual& individual) {
  const auto better = [](const Individual& a, const Individual& b) { return IsBetter(a.score, b.score); };
  const auto [first, last] = std::equal_range(best_.begin(), best_.end(), individual, better);
  // Points of one cost may be many; the same point has the same.
  if (std::any_of(first, last, [&](const Individual& other) { return other.point == individual.point; })) return;
  best_.insert(last, individual);
  if (best_.size() > most_) best_.pop_back();
}

}  // namespace fourpost
