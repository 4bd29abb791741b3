#include "analysis/deadline.h"

#include <ctime>

#include "analysis/option_check.h"

namespace fourpost {
namespace {

double ThreadTime_s() {
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Deadline Deadline::In(double seconds) {
  RequireOption(seconds > 0, "deadline", seconds, "above 0");
  Deadline deadline;
  deadline.end_s_ = ThreadTime_s() + seconds;
  return deadline;
}

bool Deadline::HasPassed() const { return end_s_ != kNever && ThreadTime_s() >= end_s_; }

}  // namespace fourpost
