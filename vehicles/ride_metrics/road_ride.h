#pragma once

#include <span>
#include <vector>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/random_response/random_vehicle.h"
#include "vehicles/ride_metrics/ride_instruments.h"
#include "vehicles/ride_metrics/ride_metrics.h"
#include "vehicles/ride_metrics/ride_spectra.h"

namespace fourpost {

/// A random road of ISO 8608 at a speed, see RandomRoad.
struct RoadRequest {
  double roughness_m3 = 0;
  double speed = 0;
  double lower_Hz = 0.5;
  double upper_Hz = 30;
  /// That peaks and doses are of.
  double duration_s = 60;
};

/// A ride over it by power spectra.
struct RoadRide {
  RideMetrics metrics;
  RideSpectra spectra;
  /// Where these spectra are, and what replaces the nonlinear elements, see RandomResponse.
  SpectralGrid grid;
  std::vector<StatisticalGain> gains;
  bool converged = false;
  int iterations = 0;
  /// Number of nonlinear elements.
  std::size_t nonlinear = 0;
  /// Largest relative change of an rms of the metrics by the last halving of the grid's panels.
  double grid_change = 0;
};

/// Refines the grid, which starts from the model's least damped mode, until no rms changes by more than a thousandth.
/// Throws std::invalid_argument naming what is out of bounds.
RoadRide RideOnRoad(const RideInstruments& instruments, const CondensedModel& model, std::span<const double> values,
                    const RoadRequest& request);

/// Least damping ratio of the model's oscillating modes within a band, for SpectralGrid::For(); 1 without any.
double LeastDampingWithin(const CondensedModel& model, double lower_Hz, double upper_Hz);

}  // namespace fourpost
