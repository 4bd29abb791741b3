#include "identify/search/parallel.h"

#include <algorithm>
#include <thread>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include "analysis/text/option_check.h"

namespace fourpost {

int ThreadCount(int threads) {
  RequireOption(threads >= 0, "threads", threads, "0 or more");
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

namespace {

void ForEachInArena(std::size_t count, const std::function<void(std::size_t)>& body) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
      },
      tbb::simple_partitioner());
}

}  // namespace

// TBB's threads outlive a batch, so a model kept per thread is built once.
void ForEachInParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  tbb::task_arena arena(threads);
  if (threads == 1) {
    arena.execute([&] {
      for (std::size_t i = 0; i < count; ++i) body(i);
    });
    return;
  }
  // More threads than processors, too, when they are asked for.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  arena.execute([&] { ForEachInArena(count, body); });
}

void ForEachOnIdleThreads(std::size_t count, const std::function<void(std::size_t)>& body) {
  tbb::this_task_arena::isolate([&] { ForEachInArena(count, body); });
}

}  // namespace fourpost
