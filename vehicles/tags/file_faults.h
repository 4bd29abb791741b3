#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "analysis/diagnostics.h"

namespace fourpost {

/// Names that fp:mirror made, each with the written name that it mirrors.
using TwinNames = std::map<std::string, std::string, std::less<>>;

/// Where the faults of one file go.
class FileFaults {
 public:
  FileFaults(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  /// From here on, what is told of a written element is not told again of its twin.
  void SetTwins(TwinNames twins) { twins_ = std::move(twins); }

  void Error(int line, std::string message);
  /// Whether a further error is shown, not only counted: none else needs suggestions, which cost time.
  bool IsShown() const { return errors_ < kMostShown; }
  /// Counts an error that follows from one already told, without telling it.
  void Follow() { ++errors_; }
  void Warning(int line, std::string message);

  const std::string& file() const { return file_; }
  /// Errors so far, in this file.
  int errors() const { return errors_; }

 private:
  /// No fewer than Diagnostics::Format shows of one file.
  static constexpr int kMostShown = 100;

  /// Notes the message; whether it is one about a twin that is told of what the twin mirrors.
  bool IsTold(int line, const std::string& message);
  /// The message with the written names in place of those made.
  std::string AsWritten(const std::string& message) const;

  std::string file_;
  Diagnostics& diagnostics_;
  int errors_ = 0;
  TwinNames twins_;
  std::set<std::pair<int, std::string>> told_;
};

}  // namespace fourpost
