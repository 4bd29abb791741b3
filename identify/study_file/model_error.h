#pragma once

#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// Parts of the misfit that are the model's fault, not the rig's: added to the measured standard deviations, so that a
/// model too simple for the data is not pulled by noise-free detail it cannot show.
struct ModelError {
  double gain_dB = 1;
  double phase_rad = 0.087266462599716474;  // 5 degrees
  double mean_m = 0.3e-3;
  /// Of amplitudes of the struts' second harmonics; zero: they are not fitted.
  double second_harmonic_m = 0;
  /// Of time histories: share of a channel's standard deviation.
  double history = 0.02;
  /// Of responses, as a share of the largest channel of that unit at that frequency: next to a node, where a channel
  /// is nearly at rest, a model that has the node elsewhere would else be wrong by many times the gain.
  double floor = 0.03;
};

/// What stands under 'model_error' of a study; the defaults without.
ModelError ReadModelError(const StrictMap& study);

/// The same of a study's text, which has been read without fault before; the defaults where it cannot be read.
ModelError ModelErrorOf(const std::string& study_text);

}  // namespace fourpost
