#pragma once

#include <chrono>
#include <string>

namespace fourpost {

/// Shows on stderr how a long task gets on: one line that is rewritten on a terminal, now and then a plain line
/// elsewhere. Short tasks stay silent elsewhere.
class ProgressLine {
 public:
  /// `start`: of the work, of which this may be a later line.
  explicit ProgressLine(std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now());
  /// Ends the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows the text, unless the last one is too fresh to be replaced. A terminal shows as much of it as goes into a
  /// line: what matters should come first.
  void Show(const std::string& text);

  /// Shows at once what comes next, after a task that was long enough to be shown.
  void ShowNext(const std::string& text);

  /// Since the start of the work.
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;

  bool terminal_;
  bool line_open_ = false;
  Clock::time_point start_;
  Clock::time_point shown_;
};

}  // namespace fourpost
