#pragma once

#include <chrono>
#include <optional>
#include <set>
#include <string>

#include "analysis/process/work_hooks.h"
#include "identify/command_line/progress_line.h"

namespace fourpost {

/// Long work on a terminal: a line of how it gets on, which notes end, until the user interrupts it.
class WorkProgress {
 public:
  /// Refer to this object.
  WorkHooks Hooks();

  /// Reports on a line of its own what has not been reported yet.
  void Tell(const Diagnostics& findings);

  /// Ends the line; the next work begins another one.
  void End() { line_.reset(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<ProgressLine> line_;
  std::set<std::string> told_;
};

}  // namespace fourpost
