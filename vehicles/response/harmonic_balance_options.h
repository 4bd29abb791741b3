#pragma once

#include "analysis/deadline.h"

namespace fourpost {

struct HarmonicBalanceOptions {
  /// Largest share of itself that more harmonics and samples would change the first harmonic of any sensor by; of a
  /// sensor near a node, that share of 3 % of what it could read. An estimate: half of what the last doubling changed,
  /// or all of it where friction or vapour take steps. What is left is a third to one and a half of it.
  double error = 2e-4;
  /// Gives up where the error needs more harmonics than these. Friction needs some that resolve its step.
  int most_harmonics = 257;
  /// Largest change of any harmonic of any port's rate in the last iteration, relative to the largest of them.
  double tolerance = 2e-5;
  /// At each number of harmonics.
  int max_iterations = 60;
  /// Asked at each frequency and in each iteration; throws TimedOut.
  Deadline deadline;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

}  // namespace fourpost
