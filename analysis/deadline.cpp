#include "analysis/deadline.h"

#include "analysis/option_check.h"

namespace fourpost {

Deadline Deadline::In(double seconds) {
  RequireOption(seconds > 0, "deadline", seconds, "above 0");
  // Longer ones would overflow the clock, and nobody sees their end.
  constexpr double kNever_s = 1e9;
  Deadline deadline;
  if (seconds < kNever_s)
    deadline.time_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  return deadline;
}

}  // namespace fourpost
