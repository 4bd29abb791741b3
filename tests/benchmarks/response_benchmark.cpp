// Cost of a whole frequency response, 40 frequencies from 0.5 to 30 Hz, all channels, one thread: by purely linear
// complex solves (the floor), by harmonic balance on the condensed model, the same with all derivatives, on the full
// system, and by the march. Then how it grows with frequencies, channels and elements that are not linear, and what a
// second thread gains.
#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>
#include <Eigen/LU>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/response/balance_sensitivity.h"
#include "vehicles/response/full_balance.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/march.h"
#include "vehicles/simulation/condensed_system.h"

namespace fourpost {
namespace {

enum class Dampers { kOfItsFile, kHydraulic, kWithoutFriction };

/// About as stiff as the Land Rover's.
HydraulicDescription Oil() {
  return {.bleed = {1.5e-6},
          .rebound_valve = {10e6},
          .compression_valve = {2.6e6},
          .bulk_modulus = {300e6},
          .piston_diameter = {0.035},
          .rod_diameter = {0.0125},
          .rebound_column = {0.15},
          .compression_column = {0.15},
          .gas_pressure = {2e6},
          .gas_volume = {60e-6},
          .gas_exponent = {1.3},
          .density = {860},
          .cavitation = {5e3}};
}

Vehicle Read(const std::string& name, Dampers dampers = Dampers::kOfItsFile) {
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle =
      ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf" / (name + ".urdf"), diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  if (dampers == Dampers::kHydraulic)
    for (Damper& damper : vehicle->dampers) damper.hydraulic = Oil();
  if (dampers == Dampers::kWithoutFriction)
    for (Damper& damper : vehicle->dampers) damper.law.friction.reset();
  return std::move(vehicle).value();
}

/// 10 mm, above 1 Hz at 63 mm/s.
Excitation Heave(std::size_t posts, int count = 40) {
  Excitation excitation;
  for (int i = 0; i < count; ++i) {
    const double frequency = 0.5 * std::pow(60, i / (count - 1.0));
    excitation.frequency_Hz.push_back(frequency);
    excitation.amplitude_m.push_back(std::min(0.01, 0.01 / frequency));
  }
  excitation.shape.assign(posts, 1);
  return excitation;
}

/// What any response costs at the least: one factorisation a frequency, and the sensors.
void ByLinearSolves(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Read(name);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Excitation excitation = Heave(vehicle.posts.size());
  const Eigen::VectorXd shape = Eigen::VectorXd::Ones(model.post_stiffness.cols());
  for ([[maybe_unused]] auto _ : state) {
    const LinearVehicle linear(model, LinearVehicle::Rates::kMean);
    Eigen::PartialPivLU<Eigen::MatrixXcd> factors(linear.size());
    Eigen::VectorXcd forces = Eigen::VectorXcd::Zero(linear.size());
    for (const double frequency : excitation.frequency_Hz) {
      const double omega = 2 * std::numbers::pi * frequency;
      const std::complex<double> iw(0, omega);
      factors.compute(linear.Impedance(omega));
      forces.head(model.mass.rows()) = model.post_stiffness * shape + iw * (model.post_damping * shape);
      const Eigen::VectorXcd motion = factors.solve(forces).head(model.mass.rows());
      Eigen::VectorXcd readings =
          model.on_position * motion + iw * (model.on_velocity * motion) + iw * iw * (model.on_acceleration * motion);
      benchmark::DoNotOptimize(readings.data());
    }
  }
}

/// With what a change of parameters costs.
void ByHarmonicBalance(benchmark::State& state, const std::string& name, Dampers dampers = Dampers::kOfItsFile,
                       const HarmonicBalanceOptions& options = {}) {
  const Vehicle vehicle = Read(name, dampers);
  const CondensedVehicle condensed(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  const Excitation excitation = Heave(vehicle.posts.size());
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(SolveHarmonicBalance(condensed.At(values), vehicle.sensors, excitation, options));
}

/// As a fit does.
void ByFewHarmonics(benchmark::State& state, const std::string& name, Dampers dampers = Dampers::kOfItsFile) {
  ByHarmonicBalance(state, name, dampers, {.few_harmonics = true, .tolerance = 1e-6});
}

/// The same with its derivatives by all parameters of the file.
void BySensitivities(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Read(name);
  const CondensedVehicle condensed(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  std::vector<std::size_t> parameters(values.size());
  std::iota(parameters.begin(), parameters.end(), std::size_t{0});
  const Excitation excitation = Heave(vehicle.posts.size());
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(SolveBalanceSensitivity(condensed, values, parameters, excitation));
}

void ByFullBalance(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Read(name);
  const CondensedVehicle condensed(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedModel model = condensed.At(values);
  Multibody multibody(vehicle);
  multibody.SetParameters(values, model.preloads);
  const Excitation excitation = Heave(vehicle.posts.size());
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(SolveFullBalance(multibody, model, excitation));
}

void ByMarch(benchmark::State& state, const std::string& name, Dampers dampers = Dampers::kOfItsFile) {
  const Vehicle vehicle = Read(name, dampers);
  const CondensedVehicle condensed(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  Multibody multibody(vehicle);
  multibody.SetParameters(values, condensed.PreloadsAt(values));
  const Excitation excitation = Heave(vehicle.posts.size());
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(
        March(multibody, excitation, {.accuracy = 1e-5, .tolerance = 1e-3, .samples_per_cycle = 64}));
}

/// Its own equations of motion in place of Simbody's, to the balance's error: of all channels, relative to the balance
/// at a hundredth of it, 2.0e-4 at most. A tolerance of 1e-3 and 64 samples leave 1.1e-3 and take half as long.
void ByMarchOfTheCondensed(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Read(name);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Excitation excitation = Heave(vehicle.posts.size());
  for ([[maybe_unused]] auto _ : state) {
    CondensedSystem system(model, RigViewOf(vehicle), 2e-3);
    benchmark::DoNotOptimize(March(system, excitation, {.tolerance = 3e-4, .samples_per_cycle = 128}));
  }
}

/// So many frequencies of the same band.
void Frequencies(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Read(name);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Excitation excitation = Heave(vehicle.posts.size(), static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(SolveHarmonicBalance(model, vehicle.sensors, excitation));
}

void FrequenciesOfFullBalance(benchmark::State& state, const std::string& name) {
  const Vehicle vehicle = Read(name);
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedModel model = CondensedVehicle(vehicle).At(values);
  Multibody multibody(vehicle);
  multibody.SetParameters(values, model.preloads);
  const Excitation excitation = Heave(vehicle.posts.size(), static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(SolveFullBalance(multibody, model, excitation));
}

/// So many sensors, those of the file over and over.
void Channels(benchmark::State& state, const std::string& name) {
  Vehicle vehicle = Read(name);
  const std::vector<Sensor> sensors = std::move(vehicle.sensors);
  vehicle.sensors.clear();
  for (std::size_t i = 0; i < static_cast<std::size_t>(state.range(0)); ++i)
    vehicle.sensors.push_back(sensors[i % sensors.size()]);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Excitation excitation = Heave(vehicle.posts.size());
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(SolveHarmonicBalance(model, vehicle.sensors, excitation));
}

/// 16 masses of 50 kg on a post and on one another, springs of 100 kN/m and dampers of 1.5 kN s/m between, the first
/// `bilinear` of which differ in their rates by a half of it; an accelerometer on the last mass.
CondensedModel Chain(Eigen::Index bilinear) {
  constexpr Eigen::Index kMasses = 16;
  constexpr double kRate = 1500;
  constexpr double kStiffness = 100e3;
  CondensedModel model;
  model.mass = 50 * Eigen::MatrixXd::Identity(kMasses, kMasses);
  model.stiffness = model.damping = Eigen::MatrixXd::Zero(kMasses, kMasses);
  for (Eigen::Index i = 0; i < kMasses; ++i) {
    Eigen::VectorXd direction = Eigen::VectorXd::Unit(kMasses, i);
    if (i > 0) direction[i - 1] = -1;
    model.stiffness += kStiffness * direction * direction.transpose();
    if (i < bilinear) model.dashpots.push_back({direction, DashpotLaw(0.75 * kRate, 1.25 * kRate), {}});
    else model.damping += kRate * direction * direction.transpose();
  }
  model.post_stiffness = kStiffness * Eigen::VectorXd::Unit(kMasses, 0);
  model.post_damping = Eigen::VectorXd::Zero(kMasses);
  model.on_position = model.on_velocity = Eigen::MatrixXd::Zero(1, kMasses);
  model.on_acceleration = Eigen::RowVectorXd::Unit(kMasses, kMasses - 1);
  model.on_post_height = model.on_post_velocity = model.on_post_acceleration = Eigen::MatrixXd::Zero(1, 1);
  return model;
}

void Elements(benchmark::State& state) {
  const CondensedModel model = Chain(state.range(0));
  const std::vector<Sensor> sensors = {{.name = "a", .type = Sensor::Type::kAccelerometer}};
  const Excitation excitation = Heave(1);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(SolveHarmonicBalance(model, sensors, excitation));
}

/// Each thread with a vehicle of its own; real time tells.
void OnThreads(benchmark::State& state, const std::string& name) { Frequencies(state, name); }

BENCHMARK_CAPTURE(ByLinearSolves, model1, "landrover110_model1")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByHarmonicBalance, model1, "landrover110_model1")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BySensitivities, model1, "landrover110_model1")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByMarchOfTheCondensed, model1, "landrover110_model1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ByMarch, model1, "landrover110_model1")->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(ByLinearSolves, model2, "landrover110_linkage")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByHarmonicBalance, model2, "landrover110_linkage")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BySensitivities, model2, "landrover110_linkage")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByFullBalance, model2, "landrover110_linkage")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ByMarch, model2, "landrover110_linkage")->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(ByLinearSolves, bushings, "landrover110")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByHarmonicBalance, bushings, "landrover110")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByFullBalance, bushings, "landrover110")->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(ByMarch, bushings, "landrover110")->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(ByHarmonicBalance, model2_hydraulic, "landrover110_linkage", Dampers::kHydraulic)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByMarch, model2_hydraulic, "landrover110_linkage", Dampers::kHydraulic)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(ByHarmonicBalance, friction, "independent_roadster")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByHarmonicBalance, without_friction, "independent_roadster", Dampers::kWithoutFriction)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByFewHarmonics, friction, "independent_roadster")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ByFewHarmonics, without_friction, "independent_roadster", Dampers::kWithoutFriction)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(Frequencies, model2, "landrover110_linkage")
    ->Arg(20)
    ->Arg(40)
    ->Arg(80)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(FrequenciesOfFullBalance, model2, "landrover110_linkage")
    ->Arg(20)
    ->Arg(40)
    ->Arg(80)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(Channels, model2, "landrover110_linkage")->Arg(1)->Arg(11)->Arg(44)->Unit(benchmark::kMicrosecond);
BENCHMARK(Elements)->Arg(2)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(OnThreads, model2, "landrover110_linkage")
    ->Arg(40)
    ->Threads(1)
    ->Threads(2)
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace fourpost

BENCHMARK_MAIN();
