#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/engine/history_solver.h"
#include "vehicles/requests/history_channel.h"

namespace fourpost {

/// Origin of a history.
struct HistoryOrigin {
  /// "road B at 60 km/h"
  std::string motion;
  HistoryEngine by;
  std::uint64_t seed = 0;
  /// Requested integration error, as a share of each channel's rms.
  double error = 0;
  bool interrupted = false;
};

/// Comma-separated text: names, units, then a row per sample; eight digits, more than any engine's accuracy.
std::string HistoryCsv(const TimeHistory& history, const std::vector<HistoryChannel>& channels);

/// The same as a universal file of double precision; as an RPC III file of floats; and its posts alone, which come
/// first and are called "post_", as a drive file of short integers.
std::string HistoryUniversal(const std::string& motion, const TimeHistory& history,
                             const std::vector<HistoryChannel>& channels);
std::string HistoryRpc(const std::string& motion, const TimeHistory& history,
                       const std::vector<HistoryChannel>& channels);
std::string HistoryDrive(const std::string& motion, const TimeHistory& history,
                         const std::vector<HistoryChannel>& channels);

/// {engine, integration, linear_kinematics_error}: the common keys of all time histories. `error`: the requested one.
nlohmann::ordered_json EngineJson(const HistoryEngine& by, double error);

/// The origin, the size of each channel, the values of all parameters, `findings` and versions; SI units.
std::string HistoryJson(const Vehicle& vehicle, const HistoryOrigin& origin, const TimeHistory& history,
                        const std::vector<HistoryChannel>& channels, const Diagnostics& findings);

}  // namespace fourpost
