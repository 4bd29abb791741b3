#pragma once

#include <chrono>
#include <exception>

namespace fourpost {

/// Thrown by Deadline::Check. No std::runtime_error, so that code which tries something else after a failed computation
/// does not go on.
class TimedOut : public std::exception {
 public:
  const char* what() const noexcept override { return "out of time"; }
};

/// When a computation has to end. Whoever computes for long takes one and asks it now and then, every few milliseconds;
/// it cannot end a computation that never asks.
class Deadline {
 public:
  /// Never.
  constexpr Deadline() = default;

  /// `seconds` from now, above 0; infinite: never.
  static Deadline In(double seconds);

  bool HasPassed() const { return time_ != Clock::time_point::max() && Clock::now() >= time_; }

  /// Throws TimedOut when it has passed.
  void Check() const {
    if (HasPassed()) throw TimedOut();
  }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point time_ = Clock::time_point::max();
};

}  // namespace fourpost
