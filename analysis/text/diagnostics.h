#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/finding.h"

namespace fourpost {

/// Where a finding is: in a file, or in an option of the command line.
struct Place {
  /// "--stroke": of the command line.
  static Place Option(std::string name) { return {.option = std::move(name)}; }

  std::string file = {};
  /// 1-based; 0 means the file as a whole.
  int line = 0;
  std::string option = {};
};

/// The option, or the file.
const std::string& Name(const Place& place);

/// A finding that was made.
struct Diagnostic {
  /// Of its Finding.
  std::string id;
  Severity severity = Severity::kError;
  Place place;
  std::string message;
  /// Those in place of `{}` of its Finding.
  std::vector<std::string> words = {};
};

/// "file:line: error: message [id]", the form editors understand; line 0 is left out. "--option: error: message [id]".
std::string Format(const Diagnostic& diagnostic);

/// Collects every finding about a user's input, so that all faults are reported at once.
class Diagnostics {
 public:
  /// `words` fill the finding's text and remedy in order.
  void Report(const Finding& finding, Place place, const std::vector<std::string>& words = {});
  /// An error that the user chose to accept, or that costs no more than a part of the input.
  void ReportAsWarning(const Finding& finding, Place place, const std::vector<std::string>& words = {});
  /// One of others.
  void Add(Diagnostic finding) { items_.push_back(std::move(finding)); }
  /// Those of others behind its own.
  void Add(const Diagnostics& others);

  bool HasErrors() const;
  const std::vector<Diagnostic>& items() const { return items_; }

  /// Errors first, then by the weight of their findings, else in their order; alike ones as Grouped().
  std::vector<Diagnostic> ByWeight() const;

  /// In their order, with one for all of the same finding about the same file, which names what each is of and the
  /// words that differ: "'a' stands still; likewise 'b' and 'c'". Errors only where they are at the same line, since
  /// editors lead to each.
  std::vector<Diagnostic> Grouped() const;

  /// One line each, alike ones as Grouped(), without a newline at the end: files with errors first, of a file its
  /// errors before its warnings, grave ones first, then by line. Of more than 100 about one file the rest is only
  /// counted.
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

/// Ends what runs with one finding. Throws FaultyInput.
[[noreturn]] void Refuse(const Finding& finding, Place place, const std::vector<std::string>& words = {});

}  // namespace fourpost
