#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fourpost {

/// An error: the input cannot be used. A warning: it can, but is likely wrong or misleading.
enum class Severity { kError, kWarning };

/// How much a finding matters beside others of its severity: one that puts the result in question is grave, one that
/// changes nothing in it is slight.
enum class Weight { kGrave, kUsual, kSlight };

/// One kind of finding: all that is written of it but names and numbers. A room lists its own in `findings.h`:
///
///     inline const Finding kMassMissing{"mass-missing", Severity::kError, "{} has no mass", "add <mass
///     value=\"...\"/>"};
///
/// Each `{}` of the text, then of the remedy, is a word of the one who reports it, in order.
class Finding {
 public:
  /// Adds itself to AllFindings(). `id` is for scripts and tests and never changes: lower case with hyphens. `remedy`
  /// is empty where the text already says what to do. Throws std::logic_error for an id that is taken.
  Finding(std::string_view id, Severity severity, std::string_view text, std::string_view remedy = {},
          Weight weight = Weight::kUsual);
  /// The same object everywhere.
  Finding(const Finding&) = delete;
  Finding& operator=(const Finding&) = delete;

  std::string_view id() const { return id_; }
  Severity severity() const { return severity_; }
  Weight weight() const { return weight_; }
  std::string_view text() const { return text_; }
  std::string_view remedy() const { return remedy_; }

  /// "text: remedy" with the words in place. Throws std::logic_error where their number is wrong.
  std::string Message(const std::vector<std::string>& words) const;

 private:
  std::string_view id_;
  Severity severity_;
  std::string_view text_;
  std::string_view remedy_;
  Weight weight_;
};

/// All that the program can find, by id.
const std::map<std::string_view, const Finding*>& AllFindings();

}  // namespace fourpost
