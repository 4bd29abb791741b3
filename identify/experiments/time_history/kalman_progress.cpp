#include "identify/experiments/time_history/kalman_progress.h"

#include <chrono>
#include <string>

#include "analysis/text/progress_text.h"

namespace fourpost {

std::function<void(int runs)> KalmanProgress(const WorkHooks& hooks) {
  using Clock = std::chrono::steady_clock;
  return [&hooks, began = Clock::now()](int runs) {
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    hooks.Show("noise of the Kalman filter: " + std::to_string(runs) + " runs of it" + Rate(runs, seconds, "runs"));
  };
}

}  // namespace fourpost
