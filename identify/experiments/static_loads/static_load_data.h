#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/residuals/residual_block.h"
#include "identify/study_file/calibration.h"
#include "identify/study_file/channel_source.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Load of a tyre at rest [N].
struct MeasuredLoad {
  std::size_t tyre = 0;
  double load_N = 0;
  double sd_N = 0;
};

/// Loads at rest as a study describes them; the path is resolved.
struct StaticLoadPlan {
  /// The study's.
  std::string file;
  std::filesystem::path table;
  /// Of the table's name in the study.
  int line = 0;
  /// Tyre of the vehicle, and the measured loads under it.
  std::vector<std::pair<std::string, ChannelSource>> tyres;
};

/// Reads the table and maps its loads to the vehicle's tyres. Adds every fault to `diagnostics`.
std::vector<MeasuredLoad> LoadStaticLoads(const StaticLoadPlan& plan, const Vehicle& vehicle, Diagnostics& diagnostics);

/// Loads under tyres at rest over their standard deviations: they pin the common scale of masses and rates, which
/// ratios of accelerations leave open.
ResidualBlock StaticLoadResiduals(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredLoad> loads,
                                  const std::vector<Calibration>& calibrations = {});

}  // namespace fourpost
