#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "identify/experiments/band_count.h"
#include "identify/experiments/bench/bench_result.h"
#include "identify/uncertainty/parameter_spread.h"

namespace fourpost {

/// What 95 of 100 measured forces are closer to the model than, as a share of the modelled rms; over all recordings.
double ForceDiscrepancy(const std::vector<ModelledRecording>& fitted);
/// `history_discrepancy` of result.json; nothing of a run without.
std::optional<double> ReadForceDiscrepancy(const std::filesystem::path& result);

struct BenchBands {
  HalfWidths about;
  BandCount count;
  std::int64_t evaluations = 0;
};

/// At the values of the vehicle's file; nothing where the vehicle has not all fitted parameters. `discrepancy`: that of
/// the fit.
std::optional<BenchBands> BandsOfForce(const BenchDamper& damper, const ModelledRecording& modelled,
                                       const Vehicle& vehicle, const ParameterSpread& spread, double discrepancy);

}  // namespace fourpost
