#include "identify/search/pattern_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fourpost {

PatternSearch::PatternSearch(const Lattice& lattice, Individual from, std::vector<Walk> walks)
    : lattice_(&lattice), at_(std::move(from)), walks_(walks.begin(), walks.end()) {
  Begin();
}

PatternSearch::PatternSearch(const Lattice& lattice, LatticePoint from, std::vector<Walk> walks)
    : lattice_(&lattice), at_{std::move(from), {}}, has_score_(false), walks_(walks.begin(), walks.end()) {
  asked_ = at_.point;
}

void PatternSearch::Tell(const Score& score) {
  if (!has_score_) {
    at_.score = score;
    has_score_ = true;
    return Begin();
  }
  if (IsBetter(score, at_.score)) {
    at_ = {*asked_, score};
    helped_ = true;
    step_ *= walks_.front().growth;
    if (AskStep()) return;
    return EndWalk();
  }
  Next();
}

void PatternSearch::Begin() {
  asked_.reset();
  while (!walks_.empty()) {
    step_ = walks_.front().step;
    direction_ = 1;
    helped_ = false;
    if (AskStep()) return;
    direction_ = -1;
    if (AskStep()) return;
    ended_.push_back({false, step_});
    walks_.pop_front();
  }
}

void PatternSearch::Next() {
  if (!helped_ && direction_ > 0) {
    direction_ = -1;
    if (AskStep()) return;
  }
  EndWalk();
}

bool PatternSearch::AskStep() {
  const std::size_t axis = walks_.front().axis;
  const std::int64_t length = std::max<std::int64_t>(1, std::llround(step_));
  const std::int64_t to = std::clamp<std::int64_t>(at_.point[axis] + direction_ * length, 1, lattice_->count(axis));
  if (to == at_.point[axis]) return false;
  asked_ = at_.point;
  (*asked_)[axis] = to;
  return true;
}

void PatternSearch::EndWalk() {
  ended_.push_back({helped_, step_});
  walks_.pop_front();
  Begin();
}

}  // namespace fourpost
