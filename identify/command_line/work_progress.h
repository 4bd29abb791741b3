#pragma once

#include <chrono>
#include <optional>

#include "analysis/process/work_hooks.h"
#include "identify/command_line/progress_line.h"

namespace fourpost {

/// Long work on a terminal: a line of how it gets on, which notes end, until the user interrupts it.
class WorkProgress {
 public:
  /// Refer to this object.
  WorkHooks Hooks();

  /// Ends the line; the next work begins another one.
  void End() { line_.reset(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<ProgressLine> line_;
};

}  // namespace fourpost
