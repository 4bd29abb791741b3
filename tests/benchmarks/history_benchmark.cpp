// Cost of a time history, 20 s of swept sine from 0.5 to 30 Hz, all channels at 500 Hz, one thread: by exact steps of
// the condensed model and by Simbody, both at settings whose error against a run of theirs at far finer ones is what
// the column `error` says: the largest over all channels of the rms of the difference, as a share of the channel's rms.
// `station`: the single wheel station's Model 3 over 35 s. Two more rows: whole evaluations of a fit to 35 s, five
// outputs, the posts sampled beforehand, of the bilinear station and of Model 3, condensed model and stepper made anew.
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/simulation/condensed_stepper.h"
#include "vehicles/simulation/condensed_system.h"
#include "vehicles/simulation/multibody_system.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {
namespace {

constexpr const char* kModel3 = "studies/single_wheel_station/model3";

Vehicle Read(const std::string& name) {
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle =
      ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / (name + ".urdf"), diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  return std::move(vehicle).value();
}

TimeGrid Grid(double duration_s) { return {.start_s = 0, .end_s = duration_s, .rate_Hz = 500}; }

/// 5 mm, above 1.9 Hz at 60 mm/s.
PostMotion Sweep(const Vehicle& vehicle, double duration) {
  const SweptSine sweep{
      .first_Hz = 0.5, .last_Hz = 30, .duration_s = duration, .amplitude_m = 0.005, .top_speed = 0.06};
  return FollowPattern(sweep.Signal(), std::vector<double>(vehicle.posts.size(), 1));
}

void Measure(benchmark::State& state, TimeSystem& system, TimeSystem& finer, const PostMotion& posts,
             double duration_s) {
  const TimeGrid grid = Grid(duration_s);
  TimeHistory history;
  for ([[maybe_unused]] auto _ : state) history = Simulate(system, posts, grid);
  state.counters["error"] = RelativeDifferences(history, Simulate(finer, posts, grid), system.rig().sensors).maxCoeff();
}

void ByCondensedSteps(benchmark::State& state, const std::string& name, double duration_s, double step_s) {
  const Vehicle vehicle = Read(name);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  CondensedSystem system(model, RigViewOf(vehicle), step_s);
  CondensedSystem finer(model, RigViewOf(vehicle), step_s / 16);
  Measure(state, system, finer, Sweep(vehicle, duration_s), duration_s);
}

void BySimbody(benchmark::State& state, const std::string& name, double duration_s, double accuracy) {
  const Vehicle vehicle = Read(name);
  const std::vector<double> values = vehicle.ParameterValues();
  Multibody multibody(vehicle);
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  MultibodySystem system(multibody, accuracy);
  MultibodySystem finer(multibody, 1e-3 * accuracy);
  Measure(state, system, finer, Sweep(vehicle, duration_s), duration_s);
}

void AnEvaluationOfAFit(benchmark::State& state, const std::string& name) {
  constexpr double kStep = 2e-3;
  constexpr int kSamples = 17501;
  const Vehicle vehicle = Read(name);
  const CondensedVehicle condensed(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  const PostMotion motion = Sweep(vehicle, 35);
  std::vector<PostState> posts(kSamples);
  for (int k = 0; k < kSamples; ++k) motion(kStep * k, {&posts[static_cast<std::size_t>(k)], 1});
  Eigen::MatrixXd readings(static_cast<Eigen::Index>(vehicle.sensors.size()), kSamples);
  for ([[maybe_unused]] auto _ : state) {
    CondensedStepper stepper(condensed.At(values), kStep);
    stepper.Start({posts.data(), 1});
    for (int k = 0; k < kSamples; ++k) {
      if (k > 0) stepper.Step({&posts[static_cast<std::size_t>(k)], 1});
      stepper.Read(readings.col(k));
    }
    benchmark::DoNotOptimize(readings.data());
  }
}

// Steps and accuracies whose errors are alike for each vehicle.
BENCHMARK_CAPTURE(ByCondensedSteps, model2, "urdf/landrover110_linkage", 20, 2e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BySimbody, model2, "urdf/landrover110_linkage", 20, 1.5e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ByCondensedSteps, bushings, "urdf/landrover110", 20, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BySimbody, bushings, "urdf/landrover110", 20, 2e-6)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(ByCondensedSteps, station, kModel3, 35, 2e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BySimbody, station, kModel3, 35, 1e-5)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(AnEvaluationOfAFit, bilinear, "urdf/single_wheel_station")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(AnEvaluationOfAFit, station, kModel3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fourpost

BENCHMARK_MAIN();
