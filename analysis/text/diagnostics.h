#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace fourpost {

enum class Severity { kError, kWarning };

/// One finding about a user's file. `line` is 1-based; 0 means the file as a whole.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string file;
  int line = 0;
  std::string message;
};

/// "file:line: error: message", the form editors understand; line 0 is left out.
std::string Format(const Diagnostic& diagnostic);

/// Collects every finding about a user's files, so that all faults are told at once.
class Diagnostics {
 public:
  void Error(std::string file, int line, std::string message);
  void Warning(std::string file, int line, std::string message);
  /// Those of others behind its own.
  void Add(const Diagnostics& others);

  bool HasErrors() const;
  const std::vector<Diagnostic>& items() const { return items_; }

  /// One line each, sorted by file and line, without a newline at the end. Of more than 100 about one file the rest is
  /// only counted.
  std::string Format() const;

 private:
  std::vector<Diagnostic> items_;
};

/// A user's input that cannot be used; `what()` is the formatted list.
class FaultyInput : public std::runtime_error {
 public:
  explicit FaultyInput(Diagnostics diagnostics);
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  Diagnostics diagnostics_;
};

}  // namespace fourpost
