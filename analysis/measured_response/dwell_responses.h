#pragma once

#include <vector>

#include "analysis/measured_response/dwell_groups.h"
#include "analysis/measured_response/response_part.h"

namespace fourpost {

/// Responses of stepped sines, recording by recording.
class DwellResponses {
 public:
  explicit DwellResponses(ResponseWork& work) : work_(work) {}

  void Add(const LookedAt& looked);
  /// Groups dwells of one pattern, amplitude and frequency, adds their responses to the work, and warns.
  void Finish();

 private:
  /// A recording without a response.
  void Refuse(const LookedAt& looked) const;
  /// Warns of stated frequencies without a response.
  void CheckStated(const std::filesystem::path& file);
  /// Of ratios nothing is left of a filter that all channels have passed; of amplitudes there is.
  void UndoFilter(DwellResponse& response) const;
  MeasuredResponse ResponseOf(const DwellGroup& group);
  void AddDwell(const DwellResponse& dwell, std::size_t c, ChannelResponse& channel) const;
  void AddQuality(const std::vector<DwellResponse>& means, std::size_t c, MeasuredResponse& out) const;
  /// The largest fundamental of all channels of the unit of this one.
  double LoudestLike(std::size_t c, const DwellResponse& mean) const;
  void CheckFilter(const std::filesystem::path& file);

  ResponseWork& work_;
  std::vector<DwellResponse> dwells_;
  std::vector<double> cycles_;
  /// Of the dwells that gave responses.
  std::vector<double> answered_Hz_;
  double unsettled_Hz_ = 0;
};

}  // namespace fourpost
