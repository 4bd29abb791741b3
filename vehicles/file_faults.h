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
  /// Counts an error that follows from one already told, without telling it.
  void Follow() { ++errors_; }
  void Warning(int line, std::string message) { diagnostics_.Warning(file_, line, std::move(message)); }

  const std::string& file() const { return file_; }
  /// Errors so far, in this file.
  int errors() const { return errors_; }

 private:
  std::string file_;
  Diagnostics& diagnostics_;
  int errors_ = 0;
};

}  // namespace fourpost
