#pragma once

#include <cstdint>
#include <vector>

#include "identify/experiments/band_count.h"
#include "identify/experiments/four_post/response_discrepancy.h"
#include "identify/experiments/subject.h"
#include "identify/uncertainty/parameter_spread.h"

namespace fourpost {

/// Half widths of bands of 95 % about a modelled response, in its unit, along and across its phasor; one per frequency.
struct ChannelBand {
  /// Of the parameters alone.
  std::vector<double> radial;
  std::vector<double> tangential;
  /// Of a new measured point: with what the model misses, and the scatter of the repeats.
  std::vector<double> radial_measured;
  std::vector<double> tangential_measured;
};

/// Of one recording.
struct ResponseBands {
  /// In the order of the recording's channels.
  std::vector<ChannelBand> channels;
  /// Of measured gains and phases.
  std::vector<BandCount> counts;
  std::int64_t evaluations = 0;
};

/// About `modelled`, the response at the values of the vehicle's file; derivatives are those of the reduced model.
/// `threads`: that evaluate it; 0: one per processor.
ResponseBands BandsOfResponse(const Subject& subject, const MeasuredRun& run, const FrequencyResponse& modelled,
                              const ParameterSpread& spread, const std::vector<OctaveDiscrepancy>& discrepancies,
                              int threads = 1);

}  // namespace fourpost
