#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/four_post/four_post_data.h"

namespace fourpost {

/// How far measured responses of one channel are from the fitted model in one octave: 95 of 100 points, as a share of
/// the level, along and across the modelled phasor, without the scatter of the repeats.
struct OctaveDiscrepancy {
  std::string channel;
  double lower_Hz = 0;
  double radial = 0;
  double tangential = 0;
};

/// The modelled gain of a channel and, next to its nodes, 3 % of the largest gain of its unit at that frequency, as
/// root of their squares: what discrepancies are shares of.
double ResponseLevel(const MeasuredRun& run, const MeasuredChannel& channel, const FrequencyResponse& modelled,
                     std::size_t frequency);

/// Of what was fitted, over all recordings; octaves from 1 Hz up and down.
std::vector<OctaveDiscrepancy> ResponseDiscrepancies(const std::vector<MeasuredRun>& runs,
                                                     const std::vector<FrequencyResponse>& modelled);

/// That of a channel nearest in frequency; of a channel that was not fitted the median of all in the nearest octave.
OctaveDiscrepancy DiscrepancyAt(const std::vector<OctaveDiscrepancy>& all, const std::string& channel,
                                double frequency_Hz);

/// `discrepancy` of result.json, and back; nothing of a run without it.
nlohmann::ordered_json DiscrepancyJson(const std::vector<OctaveDiscrepancy>& all);
std::vector<OctaveDiscrepancy> ReadDiscrepancies(const std::filesystem::path& result);

}  // namespace fourpost
