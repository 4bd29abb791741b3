#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/engine/history_solver.h"
#include "vehicles/ride_metrics/ride_metrics.h"
#include "vehicles/ride_metrics/ride_spectra.h"

namespace fourpost {

/// A ride on one road, or under another motion of the posts, found in one way.
struct RideAnswer {
  /// "road C at 60 km/h"
  std::string motion;
  /// Of its road; empty for another motion.
  std::string road_class;
  double speed = 0;
  RideMetrics metrics;
  RideSpectra spectra;
  /// By power spectra; else the engine of the time history.
  bool by_spectra = true;
  std::vector<BodyGain> gains;
  bool converged = true;
  std::size_t nonlinear = 0;
  double grid_change = 0;
  HistoryEngine by;
};

/// "spectra" or "history".
const char* WayOf(const RideAnswer& ride);

/// Comma-separated text: motion, way, metric, value, unit; SI. Unknown values are blank.
std::string RideCsv(const std::vector<RideAnswer>& rides);

/// Comma-separated text: motion, way, channel, frequency, density, unit.
std::string RideSpectraCsv(const std::vector<RideAnswer>& rides);

/// As JSON, in SI units, with the values of all parameters, `findings`, and versions.
std::string RideJson(const Vehicle& vehicle, const std::vector<RideAnswer>& rides, const Diagnostics& findings);

/// Densities of the accelerations of four points at the most and of all tyres' loads, as an SVG picture.
std::string RideSvg(const std::string& vehicle, const std::vector<RideAnswer>& rides);

}  // namespace fourpost
