#include "analysis/text/diagnostics.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "analysis/text/shortened.h"

namespace fourpost {
namespace {

/// A file that is wrong throughout must not bury the findings about others.
constexpr int kMostPerFile = 100;
/// Bytes of a message: names of megabytes in a file must not bury it. Its middle goes, since a name stands in front and
/// the remedy at the end.
constexpr std::size_t kLongest = 2000;

std::string Short(std::string text) { return text.size() > kLongest ? Shortened(text, kLongest) : std::move(text); }

void AddLine(const std::string& line, std::string& text) {
  if (!text.empty()) text += '\n';
  text += line;
}

}  // namespace

std::string Format(const Diagnostic& diagnostic) {
  std::string place = diagnostic.file;
  if (diagnostic.line > 0) place += ":" + std::to_string(diagnostic.line);
  if (!place.empty()) place += ": ";
  return place + (diagnostic.severity == Severity::kError ? "error: " : "warning: ") + diagnostic.message;
}

void Diagnostics::Error(std::string file, int line, std::string message) {
  items_.push_back({Severity::kError, Short(std::move(file)), line, Short(std::move(message))});
}

void Diagnostics::Warning(std::string file, int line, std::string message) {
  items_.push_back({Severity::kWarning, Short(std::move(file)), line, Short(std::move(message))});
}

void Diagnostics::Add(const Diagnostics& others) {
  items_.insert(items_.end(), others.items_.begin(), others.items_.end());
}

bool Diagnostics::HasErrors() const {
  return std::any_of(items_.begin(), items_.end(),
                     [](const Diagnostic& item) { return item.severity == Severity::kError; });
}

std::string Diagnostics::Format() const {
  std::vector<const Diagnostic*> sorted;
  for (const Diagnostic& item : items_) sorted.push_back(&item);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic* a, const Diagnostic* b) {
    return std::tie(a->file, a->line) < std::tie(b->file, b->line);
  });
  std::string text;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last =
        std::find_if(first, sorted.end(), [&](const Diagnostic* item) { return item->file != (*first)->file; });
    const auto shown = first + std::min<std::ptrdiff_t>(last - first, kMostPerFile);
    for (auto item = first; item != shown; ++item) AddLine(fourpost::Format(**item), text);
    if (shown != last) AddLine((*first)->file + ": " + std::to_string(last - shown) + " more", text);
    first = last;
  }
  return text;
}

FaultyInput::FaultyInput(Diagnostics diagnostics)
    : std::runtime_error(diagnostics.Format()), diagnostics_(std::move(diagnostics)) {}

}  // namespace fourpost
