// Cost of a ride by power spectra, one thread, as a choice of settings needs it: a condensed model at other values, its
// linear part at all frequencies, then six roads with all metrics. Items are roads. `frequencies`: of the grid.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/ride_metrics/road_ride.h"
#include "vehicles/ride_metrics/spectral_ride.h"

namespace fourpost {
namespace {

void SixRoads(benchmark::State& state, const std::string& name) {
  Diagnostics diagnostics;
  std::optional<Vehicle> read =
      ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf" / (name + ".urdf"), diagnostics);
  if (!read) throw FaultyInput(diagnostics);
  const Vehicle vehicle = std::move(*read);
  const RideInstruments instruments = InstrumentRide(vehicle);
  const CondensedVehicle condensed(instruments.vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  const RoadTracks tracks = RoadTracksOf(vehicle);
  const double slowest = 30 / 3.6;
  const SpectralGrid grid = SpectralGrid::For(0.5, 30, tracks.length() / slowest);
  const SpectralRide ride(instruments, grid);
  std::vector<PostSpectra> roads;
  for (const char* road_class : {"B", "C"})
    for (const double speed : {30 / 3.6, 60 / 3.6, 100 / 3.6})
      roads.push_back(RoadSpectra(tracks, RoadRoughness(road_class).value(), speed, grid));
  for ([[maybe_unused]] auto _ : state) {
    const CondensedModel model = condensed.At(values);
    const RandomVehicle random(model, grid);
    for (const PostSpectra& road : roads)
      benchmark::DoNotOptimize(ride.MetricsOf(model, values, random.Solve(road), road));
  }
  state.SetItemsProcessed(static_cast<long>(roads.size()) * state.iterations());
  state.counters["frequencies"] = static_cast<double>(grid.size());
}

BENCHMARK_CAPTURE(SixRoads, model2, "landrover110_linkage")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(SixRoads, model3, "landrover110_model3")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(SixRoads, roadster, "independent_roadster")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(SixRoads, bushings, "landrover110")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace fourpost

BENCHMARK_MAIN();
