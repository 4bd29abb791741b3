#include "vehicles/ride_metrics/spectral_ride.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/posts/road.h"
#include "vehicles/ride_metrics/history_ride.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {
namespace {

TEST(SpectralRide, Peek) {
  for (const char* name : {"landrover110_linkage", "landrover110_model3", "landrover110", "landrover110_engine", "independent_roadster", "quarter_car"}) {
    const Vehicle vehicle = ShippedVehicle(name);
    const RideInstruments instruments = InstrumentRide(vehicle);
    const CondensedVehicle condensed(instruments.vehicle);
    const double speed = 60 / 3.6;
    const RoadTracks tracks = RoadTracksOf(vehicle);
    const std::vector<double> values = vehicle.ParameterValues();
    std::vector<RideMetrics> all;
    for (const double refinement : {1.0, 2.0, 4.0}) {
      const SpectralGrid grid = SpectralGrid::For(0.5, 30, tracks.length() / speed, 0.1, refinement);
      const PostSpectra road = RoadSpectra(tracks, 256e-6, speed, grid);
      const SpectralRide ride(instruments, grid);
      const auto start = std::chrono::steady_clock::now();
      CondensedModel model = condensed.At(values);
      const auto made = std::chrono::steady_clock::now();
      const RandomVehicle random(model, grid);
      const auto prepared = std::chrono::steady_clock::now();
      const RandomResponse response = random.Solve(road);
      const auto solved = std::chrono::steady_clock::now();
      all.push_back(ride.MetricsOf(model, values, response, road));
      const auto done = std::chrono::steady_clock::now();
      const auto us = [](auto a, auto b) { return std::chrono::duration<double, std::micro>(b - a).count(); };
      std::printf("%s: %zu frequencies, %zu ports, %d iterations; model %.0f us, linear %.0f, solve %.0f, metrics %.0f\n", name, grid.size(),
                  random.ports().size(), response.iterations, us(start, made), us(made, prepared), us(prepared, solved),
                  us(solved, done));
    }
    const RandomRoad road{.roughness_m3 = 256e-6, .speed = speed, .duration_s = 123, .seed = 1};
    const RigView rig = RigViewOf(instruments.vehicle);
    CondensedHistory history = SimulateCondensed(condensed.At(values), rig, road.MotionOf(vehicle), {0, 122, 500, 0});
    history.history.DropFirst(1000);
    const RideMetrics time = RideOfHistory(instruments, condensed.At(values), values, history.history);
    const auto a = NamedMetrics(all[0]);
    const auto b = NamedMetrics(all[1]);
    const auto c = NamedMetrics(all[2]);
    const auto t = NamedMetrics(time);
    for (std::size_t i = 0; i < a.size(); ++i)
      std::printf("%-36s %12.5g %9s  grid %8.5f %8.5f  time %12.5g (%.4f)\n", a[i].name.c_str(), a[i].value, a[i].unit.c_str(),
                  a[i].value / c[i].value - 1, b[i].value / c[i].value - 1, t[i].value, a[i].value / t[i].value - 1);
  }
}

}  // namespace
}  // namespace fourpost
