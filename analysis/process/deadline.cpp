#include "analysis/process/deadline.h"

#include "analysis/process/thread_time.h"
#include "analysis/text/option_check.h"

namespace fourpost {

Deadline Deadline::In(double seconds) {
  RequireOption(seconds > 0, "deadline", seconds, "above 0");
  Deadline deadline;
  deadline.end_s_ = ThreadTime_s() + seconds;
  return deadline;
}

bool Deadline::HasPassed() const { return end_s_ != kNever && ThreadTime_s() >= end_s_; }

SharedDeadline::SharedDeadline(const Deadline& deadline) : left_s_(deadline.end_s_ - ThreadTime_s()) {}

Deadline SharedDeadline::Begin() const {
  Deadline part;
  part.end_s_ = ThreadTime_s() + left_s_;
  return part;
}

void SharedDeadline::End(double began_s) {
  const double took_s = ThreadTime_s() - began_s;
  for (double left_s = left_s_; !left_s_.compare_exchange_weak(left_s, left_s - took_s);) {
  }
}

}  // namespace fourpost
