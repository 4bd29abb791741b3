#pragma once

#include <atomic>
#include <exception>
#include <limits>

namespace fourpost {

/// Thrown by Deadline::Check. No std::runtime_error, so that code which tries something else after a failed computation
/// does not go on.
class TimedOut : public std::exception {
 public:
  const char* what() const noexcept override { return "out of time"; }
};

/// When a computation has to end, in processor time of the thread that computes: what a stopped process or a busy
/// machine takes from it does not count. Whoever computes for long takes one and asks it now and then, every few
/// milliseconds; it cannot end a computation that never asks.
class Deadline {
 public:
  /// Never.
  constexpr Deadline() = default;

  /// After `seconds` of processor time, above 0; infinite: never. To be made and asked on one thread.
  static Deadline In(double seconds);

  bool HasPassed() const;

  /// Throws TimedOut when it has passed.
  void Check() const {
    if (HasPassed()) throw TimedOut();
  }

 private:
  friend class SharedDeadline;

  static constexpr double kNever = std::numeric_limits<double>::infinity();

  // Since the thread began.
  double end_s_ = kNever;
};

/// A deadline of work whose parts may be done on several threads. A part has what is left when it begins: parts that
/// have ended count, those that other threads do meanwhile do not. To be made on the thread of the deadline.
class SharedDeadline {
 public:
  explicit SharedDeadline(const Deadline& deadline);

  /// Of a part on the calling thread.
  Deadline Begin() const;
  /// The part that the calling thread began with this much processor time behind it.
  void End(double began_s);

 private:
  std::atomic<double> left_s_ = Deadline::kNever;
};

}  // namespace fourpost
