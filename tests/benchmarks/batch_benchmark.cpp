// Responses of many cars in one pass, with which tests/python/batch_benchmark.py compares the Python module.
#include <benchmark/benchmark.h>

#include <fourpost/response.h>
#include <fourpost/vehicle.h>

namespace fp = fourpost::api;

/// 500 cars of the Land Rover's Model 3, whose front left springs go from bound to bound, by one thread.
void Batch(benchmark::State& state) {
  const fp::Vehicle car = fp::ReadVehicle(FOURPOST_SOURCE_DIR "/urdf/landrover110_model3.urdf");
  const fp::SteppedSine sine = fp::UsualSine(car);
  fp::ParameterTable table{.parameters = {"k_FL"}, .values = {}};
  for (const fp::Parameter& parameter : car.parameters())
    if (parameter.name == "k_FL") table.values = Eigen::VectorXd::LinSpaced(500, parameter.lower, parameter.upper);
  for (auto _ : state) benchmark::DoNotOptimize(fp::RespondAt(car, table, sine, {.threads = 1}));
}

BENCHMARK(Batch)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
