#pragma once

#include <memory>
#include <vector>

#include "identify/experiments/time_history/history_residuals.h"
#include "identify/residuals/residual_block.h"

namespace fourpost {

/// As a block of a study, "time histories".
ResidualBlock HistoryBlock(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredHistory> histories,
                           const HistoryResiduals::Options& options, const std::vector<Calibration>& calibrations = {});

}  // namespace fourpost
