#pragma once

namespace fourpost {

struct FullBalanceOptions {
  /// Harmonics and samples per cycle of what the full system adds to the linearised one, which has as many as it needs,
  /// see HarmonicBalanceOptions. It varies smoothly: 12 samples and 64 leave less than 5e-4 of the
  /// response between them.
  int harmonics = 5;
  int samples = 12;
  /// Largest change of any harmonic that the next iteration would make, relative to itself or to the first harmonic,
  /// whichever is larger; coordinates weighed by the work of moving each alone.
  double tolerance = 1e-5;
  /// Two to eight are needed; a frequency that takes more than this is given up.
  int max_iterations = 50;
  /// Iterates that Anderson acceleration looks back on.
  int history = 5;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

}  // namespace fourpost
