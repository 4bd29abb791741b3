#pragma once

namespace fourpost {

struct HarmonicBalanceOptions {
  /// Largest share of itself that the last doubling of harmonics and samples changed the first harmonic of any sensor
  /// by; of a sensor near a node, that share of 3 % of what it could read. What is left is some third to one and a half
  /// of it.
  double error = 2e-4;
  /// Gives up where the error needs more harmonics than these. Friction needs some that resolve
  /// its step.
  int most_harmonics = 257;
  /// Largest change of any harmonic of any port's rate in the last iteration, relative to the largest of them.
  double tolerance = 2e-5;
  /// At each number of harmonics.
  int max_iterations = 60;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

}  // namespace fourpost
