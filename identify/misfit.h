#pragma once

#include <string>
#include <vector>

#include "analysis/frequency_response.h"
#include "identify/four_post_data.h"

namespace fourpost {

/// Difference of model and measurement of one channel, root mean square over frequencies and recordings.
struct ChannelMisfit {
  std::string name;
  double rms_dB = 0;
  double rms_deg = 0;
};

/// `modelled`: one response per run, at its frequencies, one channel per sensor of the vehicle.
std::vector<ChannelMisfit> Misfits(const std::vector<MeasuredRun>& runs,
                                   const std::vector<FrequencyResponse>& modelled);

/// Root mean square over channels whose names begin with `prefix`; all of them for an empty one.
ChannelMisfit GroupMisfit(const std::vector<ChannelMisfit>& channels, const std::string& prefix);

}  // namespace fourpost
