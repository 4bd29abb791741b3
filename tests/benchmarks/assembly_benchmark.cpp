// Cost of making the models of the Land Rover 110, and of giving them other parameter values, beside that of one
// evaluation of its equations of motion in Simbody.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>

#include <benchmark/benchmark.h>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

Vehicle Named(const std::string& name) {
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle =
      ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf" / (name + ".urdf"), diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  return std::move(vehicle).value();
}

double Seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One evaluation of the accelerations [s], the least of many: what else the machine does only adds.
double EvaluationSeconds(const Vehicle& vehicle) {
  constexpr int kCalls = 1000;
  Multibody multibody(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  const Eigen::VectorXd rest = multibody.RestState();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kCalls; ++i)
    least = std::min(least, Seconds([&] { benchmark::DoNotOptimize(multibody.StateDerivative(0, rest)); }));
  return least;
}

/// Measures the work; the column `evaluations` tells its least cost in evaluations of the accelerations.
void Measure(benchmark::State& state, const Vehicle& vehicle, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for ([[maybe_unused]] auto _ : state) least = std::min(least, Seconds(work));
  state.counters["evaluations"] = least / EvaluationSeconds(vehicle);
}

void Evaluation(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Named(name);
  Multibody multibody(vehicle);
  const Eigen::VectorXd rest = multibody.RestState();
  Measure(state, vehicle, [&] { benchmark::DoNotOptimize(multibody.StateDerivative(0, rest)); });
}

void Reading(benchmark::State& state, const std::string& name) {
  Measure(state, Named(name), [&] { benchmark::DoNotOptimize(Named(name)); });
}

void MakingMultibody(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Named(name);
  Measure(state, vehicle, [&] { benchmark::DoNotOptimize(Multibody(vehicle)); });
}

void MakingCondensedVehicle(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Named(name);
  Measure(state, vehicle, [&] { benchmark::DoNotOptimize(CondensedVehicle(vehicle)); });
}

void OtherRatesInMultibody(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Named(name);
  const std::vector<double> values = vehicle.ParameterValues();
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(values);
  Multibody multibody(vehicle);
  Measure(state, vehicle, [&] { multibody.SetParameters(values, preloads); });
}

// Simbody keeps masses with the topology.
void OtherMassesInMultibody(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Named(name);
  std::vector<double> values = vehicle.ParameterValues();
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(values);
  Multibody multibody(vehicle);
  const auto mass = static_cast<std::size_t>(vehicle.links[1].mass.parameter);
  Measure(state, vehicle, [&] {
    values[mass] += 1e-6;
    multibody.SetParameters(values, preloads);
  });
}

void OtherParametersInCondensedVehicle(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Named(name);
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedVehicle condensed(vehicle);
  Measure(state, vehicle, [&] { benchmark::DoNotOptimize(condensed.At(values)); });
}

#define FOURPOST_BOTH_CARS(work)                                                    \
  BENCHMARK_CAPTURE(work, bushings, "landrover110")->Unit(benchmark::kMicrosecond); \
  BENCHMARK_CAPTURE(work, rigid, "landrover110_rigid")->Unit(benchmark::kMicrosecond);

FOURPOST_BOTH_CARS(Evaluation)
FOURPOST_BOTH_CARS(Reading)
FOURPOST_BOTH_CARS(MakingMultibody)
FOURPOST_BOTH_CARS(MakingCondensedVehicle)
FOURPOST_BOTH_CARS(OtherRatesInMultibody)
FOURPOST_BOTH_CARS(OtherMassesInMultibody)
FOURPOST_BOTH_CARS(OtherParametersInCondensedVehicle)

}  // namespace
}  // namespace fourpost

BENCHMARK_MAIN();
