// Cost of one objective evaluation of the Land Rover study, by harmonic balance and by marching the same responses.
#include <filesystem>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "identify/loaded_study.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/march.h"

namespace fourpost {
namespace {

LoadedStudy Study() {
  Diagnostics diagnostics;
  std::optional<LoadedStudy> study =
      LoadStudy(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/landrover110/model2.yaml", diagnostics);
  if (!study) throw FaultyInput(diagnostics);
  return std::move(study).value();
}

void ByHarmonicBalance(benchmark::State& state) {
  const VehicleObjective objective = Study().MakeObjective();
  Eigen::VectorXd values(static_cast<Eigen::Index>(objective.free().size()));
  for (std::size_t i = 0; i < objective.free().size(); ++i)
    values[static_cast<Eigen::Index>(i)] = objective.vehicle().parameters[objective.free()[i]].value;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(objective.Evaluate(values));
}

void ByMarch(benchmark::State& state) {
  const LoadedStudy study = Study();
  const CondensedVehicle condensed(study.vehicle);
  const std::vector<double> values = study.vehicle.ParameterValues();
  Multibody multibody(study.vehicle);
  multibody.SetParameters(values, condensed.PreloadsAt(values));
  MarchOptions options;
  options.accuracy = 1e-5;
  options.tolerance = 1e-3;
  // As few as balance takes, so that dense sampling does not flatter the comparison.
  options.samples_per_cycle = 64;
  for ([[maybe_unused]] auto _ : state)
    for (const MeasuredRun& run : InBand(study.data.runs, study.study.band_lower_Hz, study.study.band_upper_Hz))
      benchmark::DoNotOptimize(March(multibody, run.excitation, options));
}

BENCHMARK(ByHarmonicBalance)->Unit(benchmark::kMillisecond);
BENCHMARK(ByMarch)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace fourpost

BENCHMARK_MAIN();
