#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/history_channel.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// How a history came about.
struct HistoryOrigin {
  /// "road B at 60 km/h"
  std::string motion;
  std::string engine;
  std::uint64_t seed = 0;
  /// Of each channel's rms, asked of the integration.
  double error = 0;
  /// Of the condensed engine: the step it came to, and by how much its last halving changed the channel that it changed
  /// most, as a share of its rms. The full one does not measure that.
  std::optional<double> step_s;
  std::optional<double> change;
  bool interrupted = false;
};

/// Comma-separated text: names, units, then a row per sample, eight digits; more than any engine's error.
std::string HistoryCsv(const TimeHistory& history, const std::vector<HistoryChannel>& channels);

/// The origin, how large each channel is, the values of all parameters, `findings` and versions; SI units.
std::string HistoryJson(const Vehicle& vehicle, const HistoryOrigin& origin, const TimeHistory& history,
                        const std::vector<HistoryChannel>& channels, const Diagnostics& findings);

}  // namespace fourpost
