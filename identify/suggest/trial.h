#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identify/suggest/addition.h"
#include "identify/suggest/augmented_study.h"
#include "identify/suggest/score_test.h"

namespace fourpost {

/// An addition under test.
struct Trial {
  Addition addition;
  std::unique_ptr<AugmentedStudy> study;
  std::optional<ScoreTest> test;
  /// SI, of its parameters, where they were fitted each on its own.
  std::vector<double> values;
  /// Why there is no test.
  std::string failure;

  AmountRange range() const { return {addition.first, addition.least, addition.greatest}; }

  /// Whether it is a channel's error of more than its range, and the cost falls by it from `before` by less than half:
  /// no rig is that far off, and what the vehicle lacks imitates it. A wrong unit or amplitude explains nearly all.
  bool IsImitation(double before) const {
    if (!addition.study || !test) return false;
    const bool is_at_end = test->amount <= addition.least || test->amount >= addition.greatest;
    return is_at_end && test->cost > 0.5 * before;
  }
};

}  // namespace fourpost
