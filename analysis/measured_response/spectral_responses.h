#pragma once

#include <string>
#include <vector>

#include "analysis/measured_response/response_part.h"

namespace fourpost {

/// Responses of sweeps, random motions and multisines, recording by recording.
class SpectralResponses {
 public:
  explicit SpectralResponses(ResponseWork& work) : work_(work) {}

  void Add(const LookedAt& looked);
  /// Joins those of one motion, adds them to the work, and warns.
  void Finish();

 private:
  bool AddLocal(const LookedAt& looked, const std::vector<double>& motion, MeasuredResponse& out);
  bool AddMultisine(const LookedAt& looked, const std::vector<double>& motion, MeasuredResponse& out);
  /// The largest of all channels is reported.
  void NoteDistortion(std::vector<std::string> words, double distortion);
  /// The largest incoherent share of a channel where it moves by a tenth of its most, once.
  void CheckCoherence(const MeasuredResponse& response);

  ResponseWork& work_;
  std::vector<MeasuredResponse> parts_;
  double most_distorted_ = 0;
  std::vector<std::string> distortion_words_;
};

}  // namespace fourpost
