// What the archive costs and gains: evaluations of uneven length on several threads, and what storing one takes.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include <benchmark/benchmark.h>

#include "analysis/signals/random_stream.h"
#include "identify/search/archive.h"

namespace fourpost {
namespace {

/// Work of a size, so that threads which share a core take twice as long.
double Compute(double ms) {
  double sum = 0;
  for (int i = 0; i < static_cast<int>(3e5 * ms); ++i) sum += std::sqrt(sum + i);
  return sum;
}

/// Takes the same time however busy the cores are: what is lost is lost by the scheduling alone.
double Wait(double ms) {
  std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(ms));
  return ms;
}

/// Log-normal lengths of 1 ms in the middle: one in a hundred takes ten times as long.
Problem Uneven(double (*take)(double ms)) {
  return {Lattice({{"number", 0, 1e6, 1}}), [take](const Eigen::VectorXd& p) {
            RandomStream stream(1, "evaluations", static_cast<std::uint64_t>(p[0]));
            Evaluation evaluation;
            evaluation.residuals = Eigen::VectorXd::Constant(1, take(std::exp(stream.Normal())));
            return evaluation;
          }};
}

/// 400 evaluations in batches of a size: a search asks for 20, and each batch waits for its longest.
void UnevenLengths(benchmark::State& state, double (*take)(double ms)) {
  const std::int64_t size = state.range(1);
  for ([[maybe_unused]] auto _ : state) {
    Archive archive(Uneven(take), static_cast<int>(state.range(0)));
    for (std::int64_t first = 1; first <= 400; first += size) {
      std::vector<LatticePoint> batch;
      for (std::int64_t i = 0; i < size; ++i) batch.push_back({first + i});
      benchmark::DoNotOptimize(archive.Evaluate(batch));
    }
  }
}

/// A new file per run of the benchmark, with as many residuals as the Land Rover's study.
class File {
 public:
  File() : file_(std::filesystem::temp_directory_path() / "fourpost_archive_benchmark.sqlite") { Remove(); }
  ~File() { Remove(); }
  const std::filesystem::path& path() const { return file_; }

 private:
  void Remove() const {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file_.string() + end);
  }
  std::filesystem::path file_;
};

Evaluation LandRoverSized() {
  Evaluation evaluation;
  evaluation.residuals = Eigen::VectorXd::LinSpaced(2354, 0, 1);
  return evaluation;
}

Eigen::VectorXd Values(double number) { return Eigen::VectorXd::LinSpaced(12, number, number + 1); }

void Store(benchmark::State& state) {
  const File file;
  EvaluationStore store(file.path(), {});
  const Evaluation evaluation = LandRoverSized();
  double number = 0;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(store.Put(Values(number++), evaluation));
}

void FindStored(benchmark::State& state) {
  const File file;
  EvaluationStore store(file.path(), {});
  const Evaluation evaluation = LandRoverSized();
  for (int number = 0; number < 1000; ++number) store.Put(Values(number), evaluation);
  int number = 0;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(store.Find(Values(number++ % 1000)));
}

void ThreadsAndBatches(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"threads", "batch"})->ArgsProduct({{1, 2}, {20, 400}});
  benchmark->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(UnevenLengths, wait, Wait)->Apply(ThreadsAndBatches);
BENCHMARK_CAPTURE(UnevenLengths, compute, Compute)->Apply(ThreadsAndBatches);
BENCHMARK(Store)->UseRealTime()->Iterations(5000)->Unit(benchmark::kMicrosecond);
BENCHMARK(FindStored)->UseRealTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace fourpost

BENCHMARK_MAIN();
