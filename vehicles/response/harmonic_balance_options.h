#pragma once

#include "analysis/process/deadline.h"

namespace fourpost {

struct HarmonicBalanceOptions {
  /// Largest relative change of the first harmonic of any sensor by more harmonics and samples; for a sensor near a
  /// node, relative to 3 % of its largest possible reading. An estimate: half of the change by the last doubling, or
  /// all of it if friction or vapour have sharp transitions. The actual error is a third to one and a half of it.
  double error = 2e-4;
  /// Instead of as many harmonics as the error needs: 9, or 17 where there is friction, whatever the error. A fit
  /// differentiates, and more harmonics at one point than at the next would look like a slope.
  bool few_harmonics = false;
  /// Stops if the error needs more harmonics than these. Friction needs enough to resolve its transition.
  int most_harmonics = 257;
  /// Largest change of any harmonic of any element's rate in the last iteration, relative to the largest of them: of
  /// the plain iteration or of Newton's method, also where that is approximate.
  double tolerance = 2e-5;
  /// At each number of harmonics.
  int max_iterations = 60;
  /// Checked at each frequency and in each iteration; throws TimedOut.
  Deadline deadline;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

}  // namespace fourpost
