// Cost of one objective evaluation of the Land Rover's studies, by harmonic balance and by marching the same responses
// in Simbody, and of a whole fit of Model 1, to set against what its evaluations would have cost by marching.
#include <filesystem>
#include <stdexcept>
#include <string>

#include <benchmark/benchmark.h>

#include "identify/experiments/four_post/four_post.h"
#include "identify/fit/fit.h"
#include "identify/study/loaded_study.h"
#include "identify/study/study_methods.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/march.h"

namespace fourpost {
namespace {

LoadedStudy Study(const std::string& name) {
  Diagnostics diagnostics;
  const std::filesystem::path folder = std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/landrover110";
  std::optional<LoadedStudy> study = LoadStudy(folder / (name + ".yaml"), diagnostics);
  if (!study) throw FaultyInput(diagnostics);
  return std::move(study).value();
}

void ByHarmonicBalance(benchmark::State& state, const std::string& name) {
  const VehicleObjective objective = Study(name).MakeObjective();
  const Eigen::VectorXd values = objective.FileValues();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(objective.Evaluate(values));
}

void ByMarch(benchmark::State& state, const std::string& name) {
  const LoadedStudy study = Study(name);
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
    for (const MeasuredRun& run : InBand(study.study.experiments.Find<FourPost>()->runs,
                                         study.study.experiments.Find<FourPost>()->plan.band_lower_Hz,
                                         study.study.experiments.Find<FourPost>()->plan.band_upper_Hz))
      benchmark::DoNotOptimize(March(multibody, run.excitation, options));
}

/// As `fourpost fit` does it: exploration, five refinements, deviations.
void WholeFit(benchmark::State& state, const std::string& name) {
  const LoadedStudy study = Study(name);
  const VehicleObjective objective = study.MakeObjective();
  FitOptions options;
  Diagnostics diagnostics;
  options.search = ExplorationOf(study.study, objective.MakeProblem(), diagnostics);
  options.stop.max_evaluations = study.study.search.evaluations.value();
  options.refine.differences = Differences::kAutomatic;
  options.identify_first = true;
  for ([[maybe_unused]] auto _ : state) {
    const FitResult fit = Fit(objective, options);
    state.SetLabel(std::to_string(fit.evaluations.paid) + " evaluations; " + std::to_string(fit.agreeing) + " of " +
                   std::to_string(fit.starts) + " agree");
  }
}

BENCHMARK_CAPTURE(ByHarmonicBalance, model1, "model1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ByHarmonicBalance, model2, "model2")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ByHarmonicBalance, full, "full")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(WholeFit, model1, "model1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ByMarch, model1, "model1")->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(ByMarch, model2, "model2")->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(ByMarch, full, "full")->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace fourpost

BENCHMARK_MAIN();
