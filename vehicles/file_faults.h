#pragma once

#include <string>
#include <utility>

#include "analysis/diagnostics.h"

namespace fourpost {

/// Where the faults of one file go.
class FileFaults {
 public:
  FileFaults(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  void Error(int line, std::string message) {
    diagnostics_.Error(file_, line, std::move(message));
    ++errors_;
  }
  /// Whether a further error is shown, not only counted: none else needs suggestions, which cost time.
  bool IsShown() const { return errors_ < kMostShown; }
  /// Counts an error that follows from one already told, without telling it.
  void Follow() { ++errors_; }
  void Warning(int line, std::string message) { diagnostics_.Warning(file_, line, std::move(message)); }

  const std::string& file() const { return file_; }
  /// Errors so far, in this file.
  int errors() const { return errors_; }

 private:
  /// No fewer than Diagnostics::Format shows of one file.
  static constexpr int kMostShown = 100;

  std::string file_;
  Diagnostics& diagnostics_;
  int errors_ = 0;
};

}  // namespace fourpost
