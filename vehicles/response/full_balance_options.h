#pragma once

namespace fourpost {

struct FullBalanceOptions {
  /// Harmonics and samples per cycle of the full system's difference from the linearised one, which has as many as it
  /// needs, see HarmonicBalanceOptions. The difference varies smoothly: 12 samples leave an error of some percent of
  /// it.
  int harmonics = 5;
  int samples = 12;
  /// Used instead if the full system changes a sensor by more than 1 %, so that some percent of that would be visible.
  /// Half of them are used from the start if a damper has friction, which changes its sign at other instants in the two
  /// systems.
  int fine_harmonics = 31;
  int fine_samples = 128;
  /// Largest change of any harmonic by the next iteration, and largest motion due to the remaining lacking force,
  /// relative to that harmonic or to the first one, whichever is larger; coordinates weighted by the work of moving
  /// each alone.
  double tolerance = 1e-5;
  /// Two to eight are needed; a frequency that takes more than this is unconverged.
  int max_iterations = 60;
  /// Number of previous iterates in Anderson acceleration.
  int history = 20;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

}  // namespace fourpost
