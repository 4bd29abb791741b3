#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/comfort/weighting.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/random_response/random_vehicle.h"
#include "vehicles/ride_metrics/ride_instruments.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// One-sided power spectral densities of what a ride is judged by.
struct RideSpectra {
  struct Channel {
    std::string name;
    /// "m/s^2", whose density is in (m/s^2)^2/Hz, or "N".
    std::string unit;
    std::vector<double> density;
  };
  std::vector<double> frequency_Hz;
  /// Accelerations of the points, loads of the tyres; unweighted.
  std::vector<Channel> channels;
};

/// Density of a channel's acceleration as it is felt: times |W|^2.
std::vector<double> WeightedDensity(const RideSpectra& spectra, std::size_t channel, Weighting weighting);

/// `grid`: of the response.
RideSpectra SpectraOf(const RideInstruments& instruments, const SpectralGrid& grid, const RandomResponse& response);

/// By Welch's method, up to `upper_Hz`.
RideSpectra SpectraOf(const RideInstruments& instruments, const TimeHistory& history, double upper_Hz);

/// How much the chassis moves for the posts: the largest gain over a road's band, nonlinear elements by their gains on
/// it.
struct BodyGain {
  /// See PostPattern.
  std::string pattern;
  /// Of the chassis' heave [m/m], pitch or roll [rad/m] per amplitude of the posts; and of its acceleration [m/s^2 or
  /// rad/s^2 per m].
  double largest = 0;
  double at_Hz = 0;
  double largest_acceleration = 0;
  double acceleration_at_Hz = 0;
};

/// Heave for heave, pitch for pitch, roll for roll; those patterns that the posts can make. Empty without a chassis.
std::vector<BodyGain> BodyGainsOf(const RideInstruments& instruments, const RandomVehicle& vehicle,
                                  const std::vector<StatisticalGain>& gains);

}  // namespace fourpost
