#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace fourpost {

/// Shows on stderr how a long task gets on: one line that is rewritten on a terminal, now and then a plain line
/// elsewhere. Short tasks stay silent elsewhere. What lasts without news is shown again with the time that it has taken:
/// one evaluation may take minutes.
class ProgressLine {
 public:
  /// `start`: of the work, of which this may be a later line. `beat`: after how long it is shown again.
  explicit ProgressLine(std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now(),
                        std::chrono::steady_clock::duration beat = std::chrono::seconds(5));
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

  void Beat();
  void Print(const std::string& text);

  bool terminal_;
  Clock::duration beat_;
  Clock::time_point start_;
  /// Of all below.
  std::mutex mutex_;
  std::condition_variable wake_;
  bool line_open_ = false;
  bool ended_ = false;
  Clock::time_point shown_;
  std::string text_;
  std::thread beating_;
};

}  // namespace fourpost
