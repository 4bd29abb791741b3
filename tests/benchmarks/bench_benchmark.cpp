// Cost of a damper's law over its bench recording, the 40 s sweep at 500 Hz of studies/damper, one thread: the whole
// model of each study (series spring, friction, the rig's filter), and for Model 3 a plain loop over the samples that
// only evaluates its law.
#include <filesystem>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "identify/experiments/bench/damper_bench.h"
#include "identify/study/loaded_study.h"
#include "vehicles/bench/series_history.h"

namespace fourpost {
namespace {

LoadedStudy Load(const std::string& name) {
  Diagnostics diagnostics;
  std::optional<LoadedStudy> study =
      LoadStudy(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/damper" / (name + ".yaml"), diagnostics);
  if (!study) throw FaultyInput(diagnostics);
  return std::move(study).value();
}

SeriesDamper Model3(const LoadedStudy& study) {
  const std::vector<double> values = study.vehicle.ParameterValues();
  const Damper& damper = study.vehicle.dampers[0];
  return {damper.law.At(values), damper.series->At(values)};
}

void LawAlone(benchmark::State& state) {
  const LoadedStudy study = Load("model3");
  const SeriesDamper damper = Model3(study);
  const BenchMotion& motion = study.study.experiments.Find<DamperBench>()->data.fitted[0].motion;
  const std::size_t count = motion.samples();
  std::vector<double> speed(count);
  std::vector<double> spring(count);
  for (std::size_t k = 0; k < count; ++k) {
    speed[k] = motion.rate[k * motion.steps];
    spring[k] = damper.dashpot.Force(speed[k]) / damper.spring.stiffness;
  }
  std::vector<double> rates(count);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t k = 0; k < count; ++k) rates[k] = damper.SpringRate(speed[k], spring[k]);
    benchmark::DoNotOptimize(rates.data());
    benchmark::ClobberMemory();
  }
}

void SeriesHistoryOfModel3(benchmark::State& state) {
  const LoadedStudy study = Load("model3");
  const SeriesDamper damper = Model3(study);
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(SeriesForces(damper, study.study.experiments.Find<DamperBench>()->data.fitted[0].motion));
}

void EvaluationOf(benchmark::State& state, const std::string& name) {
  const LoadedStudy study = Load(name);
  const VehicleObjective objective = study.MakeObjective();
  const Eigen::VectorXd values = objective.FileValues();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(objective.Evaluate(values));
}

}  // namespace
}  // namespace fourpost

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("LawAlone", fourpost::LawAlone)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("SeriesHistoryOfModel3", fourpost::SeriesHistoryOfModel3)->Unit(benchmark::kMicrosecond);
  for (const char* name : {"model1", "model2", "model3", "model4", "model5", "friction_knees"})
    benchmark::RegisterBenchmark(("Evaluation/" + std::string(name)).c_str(), fourpost::EvaluationOf, std::string(name))
        ->Unit(benchmark::kMicrosecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
