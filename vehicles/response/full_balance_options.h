#pragma once

namespace fourpost {

struct FullBalanceOptions {
  /// Harmonics and samples per cycle of what the full system adds to the linearised one, which has as many as it needs,
  /// see HarmonicBalanceOptions. It varies smoothly: 12 samples miss some percent of it.
  int harmonics = 5;
  int samples = 12;
  /// In place of fewer where the full system moves a sensor by more than 1 %, so that some percent of that could be
  /// seen. Half of them at once where a damper has friction, which changes its sign at other instants in the two
  /// systems.
  int fine_harmonics = 31;
  int fine_samples = 128;
  /// Largest change of any harmonic that the next iteration would make, and largest motion by what the full system
  /// would still lack, relative to that harmonic or to the first one, whichever is larger; coordinates weighed by the
  /// work of moving each alone.
  double tolerance = 1e-5;
  /// Two to eight are needed; a frequency that takes more than this is given up.
  int max_iterations = 60;
  /// Iterates that Anderson acceleration looks back on.
  int history = 20;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

}  // namespace fourpost
