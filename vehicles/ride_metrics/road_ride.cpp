#include "vehicles/ride_metrics/road_ride.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "vehicles/condensed/modes.h"
#include "vehicles/ride_metrics/spectral_ride.h"

namespace fourpost {
namespace {

constexpr double kGridError = 1e-3;
constexpr int kMostRefinements = 4;

/// The mean squares that a grid must integrate.
std::vector<double> RmsOf(const RideMetrics& metrics) {
  std::vector<double> rms;
  for (const RideMetrics::Comfort& comfort : metrics.comfort)
    rms.insert(rms.end(), {comfort.rms, comfort.weighted.rms});
  for (const RideMetrics::Wheel& wheel : metrics.wheels) rms.push_back(wheel.rms_N);
  for (const RideMetrics::Strut& strut : metrics.struts) rms.insert(rms.end(), {strut.travel_rms_m, strut.speed_rms});
  return rms;
}

double LargestChange(const std::vector<double>& coarse, const std::vector<double>& fine) {
  double largest = 0;
  for (std::size_t i = 0; i < fine.size(); ++i)
    if (fine[i] > 0) largest = std::max(largest, std::abs(coarse[i] / fine[i] - 1));
  return largest;
}

}  // namespace

double LeastDampingWithin(const CondensedModel& model, double lower_Hz, double upper_Hz) {
  double least = 1;
  for (const Mode& mode : ModesOf(model))
    if (mode.kind == Mode::Kind::kOscillating && mode.frequency_Hz > lower_Hz && mode.frequency_Hz < upper_Hz)
      least = std::min(least, mode.damping_ratio);
  return least;
}

RoadRide RideOnRoad(const RideInstruments& instruments, const CondensedModel& model, std::span<const double> values,
                    const RoadRequest& request) {
  const double damping = LeastDampingWithin(model, request.lower_Hz, request.upper_Hz);
  RoadRide ride;
  std::vector<double> last;
  double refinement = 1;
  for (int k = 0; k <= kMostRefinements; ++k, refinement *= 2) {
    const SpectralGrid grid =
        SpectralGrid::For(request.lower_Hz, request.upper_Hz, instruments.tracks.length() / request.speed,
                          std::max(damping, 1e-3), refinement);
    const PostSpectra road = RoadSpectra(instruments.tracks, request.roughness_m3, request.speed, grid);
    const RandomVehicle vehicle(model, grid);
    RandomResponse response = vehicle.Solve(road);
    ride.metrics = SpectralRide(instruments, grid, request.duration_s).MetricsOf(model, values, response, road);
    ride.spectra = SpectraOf(instruments, grid, response);
    ride.grid = grid;
    ride.gains = std::move(response.gains);
    ride.converged = response.converged;
    ride.iterations = response.iterations;
    ride.nonlinear = vehicle.ports().size();
    const std::vector<double> rms = RmsOf(ride.metrics);
    ride.grid_change = last.empty() ? 1 : LargestChange(last, rms);
    last = rms;
    if (!ride.converged || ride.grid_change <= kGridError) break;
  }
  return ride;
}

}  // namespace fourpost
