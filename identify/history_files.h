#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnostics.h"
#include "identify/history_channel.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/engine/history_solver.h"

namespace fourpost {

/// How a history came about.
struct HistoryOrigin {
  /// "road B at 60 km/h"
  std::string motion;
  HistoryEngine by;
  std::uint64_t seed = 0;
  /// Of each channel's rms, asked of the integration.
  double error = 0;
  bool interrupted = false;
};

/// Comma-separated text: names, units, then a row per sample, eight digits; more than any engine's error.
std::string HistoryCsv(const TimeHistory& history, const std::vector<HistoryChannel>& channels);

/// {engine, integration, linear_kinematics_error}: what each answer over time says of itself. `error`: asked for.
nlohmann::ordered_json EngineJson(const HistoryEngine& by, double error);

/// The origin, how large each channel is, the values of all parameters, `findings` and versions; SI units.
std::string HistoryJson(const Vehicle& vehicle, const HistoryOrigin& origin, const TimeHistory& history,
                        const std::vector<HistoryChannel>& channels, const Diagnostics& findings);

}  // namespace fourpost
