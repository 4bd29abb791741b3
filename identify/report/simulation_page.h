#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/recorded_motion.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/requests/history_channel.h"
#include "vehicles/requests/history_files.h"

namespace fourpost {

/// What `fourpost simulate` answered, to be shown.
struct SimulationAnswer {
  HistoryOrigin origin;
  double start_s = 0;
  double rate_Hz = 0;
  std::vector<HistoryChannel> channels;
  /// How the vehicle moves in it; without rows: it is not shown.
  HistoryMotion motion;
  Diagnostics findings;
};

/// A page of a time history: the size of its channels, their charts and spectra, and the vehicle moving in it.
std::string SimulationPage(const Vehicle& vehicle, const SimulationAnswer& answer);

}  // namespace fourpost
