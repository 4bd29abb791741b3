#pragma once

namespace fourpost {

/// What the program answers to the shell.
enum ExitCode {
  kGood = 0,
  /// Done, but not as wished: a fit that did not converge.
  kNotGood = 1,
  kUsage = 2,
  kUnreadableInput = 3,
  kAllSimulationsFailed = 4,
  kCannotWrite = 5,
  /// A defect of the program: EX_SOFTWARE of sysexits.h.
  kDefect = 70,
  /// The system has no memory left: EX_OSERR of sysexits.h.
  kOutOfMemory = 71,
  /// Others kept it from its end, and it goes on when it is run again: EX_TEMPFAIL of sysexits.h.
  kNotDone = 75,
  /// 128 + SIGINT, as shells report it.
  kInterrupted = 130,
};

}  // namespace fourpost
