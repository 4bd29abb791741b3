#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/band_count.h"
#include "identify/experiments/time_history/history_residuals.h"
#include "identify/uncertainty/parameter_spread.h"

namespace fourpost {

/// How far measured samples of a channel are from the fitted model: 95 of 100, as a share of the modelled rms.
struct HistoryDiscrepancy {
  std::string channel;
  double share = 0;
};

/// Over all recordings.
std::vector<HistoryDiscrepancy> HistoryDiscrepancies(const std::vector<MeasuredHistory>& histories,
                                                     const std::vector<Eigen::MatrixXd>& modelled);

nlohmann::ordered_json DiscrepancyJson(const std::vector<HistoryDiscrepancy>& all);
/// `history_discrepancy` of result.json; of a run that fitted stepped sines alone from its `discrepancy`; nothing of
/// one with neither.
std::vector<HistoryDiscrepancy> ReadHistoryDiscrepancies(const std::filesystem::path& result);

/// Half widths of bands of 95 % about the signals of one history, samples x signals in their units: of the parameters
/// alone, and of a new measurement.
struct HistoryBands {
  /// The first sample of the window and every `stride`-th after it.
  Eigen::Index stride = 1;
  Eigen::MatrixXd parameters;
  Eigen::MatrixXd measured;
  std::vector<BandCount> counts;
  std::int64_t evaluations = 0;
};

/// About `modelled` of the one history of `reduced`, at the values of the vehicle's file; derivatives are those of the
/// reduced model. Channels that the fit does not know have the median of all others.
HistoryBands BandsOfHistory(const HistoryResiduals& reduced, const Vehicle& vehicle, const Eigen::MatrixXd& modelled,
                            const ParameterSpread& spread, const std::vector<HistoryDiscrepancy>& discrepancies);

}  // namespace fourpost
