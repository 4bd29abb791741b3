#pragma once

#include <optional>
#include <vector>

#include "identify/missing_force/force_mechanism.h"

namespace fourpost {

/// A mechanism that explains a missing force.
struct ForceExplanation {
  ForceMechanism mechanism;
  /// N/m, N s/m, N or kg, and its standard deviation, with what the mechanism's force shares with free parameters and
  /// with what a good rig may be off by; given the other explanations.
  double amount = 0;
  double sd = 0;
  /// Between these frequencies lie nine tenths of what it explains.
  double lower_Hz = 0;
  double upper_Hz = 0;
  /// Its largest force or moment on a coordinate, over that band; along its line where it has one [N].
  double most_N = 0;
  /// Share of the squares that noise does not explain, before anything was taken out.
  double share = 0;
  /// Fall of the sum of squares over its mean when nothing is missing, less what choosing its shape is worth: the
  /// square of a normal variable then.
  double score = 0;
  /// Those that would explain it as well.
  std::vector<ForceMechanism> rivals;
};

/// A missing force without a name.
struct UnexplainedForce {
  /// At which most of its squares lie, of all recordings together, and between which nine tenths of them do.
  double frequency_Hz = 0;
  double lower_Hz = 0;
  double upper_Hz = 0;
};

struct ForceExplanations {
  std::vector<ForceExplanation> found;
  /// What all of them leave, where that is beyond noise.
  std::optional<UnexplainedForce> left = {};
  /// Root mean square of the missing force over its noise, with free parameters where they explain most: about 1 where
  /// nothing is missing. NaN without a sample.
  double misfit = 0;
};

/// Names what explains a missing force F. With F_k = sum_j a_j g_j + sum_i t_i d_i + noise, g_j the force of a
/// mechanism per amount, d_i that of one standard deviation of a free parameter or of what a good rig may be off by and
/// t_i a standard normal variable, the mechanism is chosen that lowers the weighted squares most; it is taken out and
/// the search goes on, at most three times. Nothing is named that is below 4.5 standard deviations, noise widened where
/// what is left over is correlated or exceeds it, also without the frequency that speaks for it most, for one wrong
/// reading is explained best by a part that resonates there; or that explains less than a tenth. Of
/// several, the weakest is dropped while its amount is less than three of its standard deviations beside the others.
/// Amounts are in the scale of the fitted masses, rates and dampings, whose common factor motions do not show.
ForceExplanations ExplainForce(const ForceRecord& record);

}  // namespace fourpost
