#include "analysis/text/diagnostics.h"

#include <algorithm>
#include <set>
#include <string_view>
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

Weight WeightOf(const Diagnostic& diagnostic) {
  const auto finding = AllFindings().find(diagnostic.id);
  return finding == AllFindings().end() ? Weight::kUsual : finding->second->weight();
}

}  // namespace

const std::string& Name(const Place& place) { return place.option.empty() ? place.file : place.option; }

std::string Format(const Diagnostic& diagnostic) {
  std::string place = Name(diagnostic.place);
  if (diagnostic.place.line > 0) place += ":" + std::to_string(diagnostic.place.line);
  if (!place.empty()) place += ": ";
  const std::string id = diagnostic.id.empty() ? "" : " [" + diagnostic.id + "]";
  return place + (diagnostic.severity == Severity::kError ? "error: " : "warning: ") + diagnostic.message + id;
}

void Diagnostics::Report(const Finding& finding, Place place, const std::vector<std::string>& words) {
  place.file = Short(std::move(place.file));
  items_.push_back({std::string(finding.id()), finding.severity(), std::move(place), Short(finding.Message(words))});
}

void Diagnostics::ReportAsWarning(const Finding& finding, Place place, const std::vector<std::string>& words) {
  Report(finding, std::move(place), words);
  items_.back().severity = Severity::kWarning;
}

void Diagnostics::Add(const Diagnostics& others) {
  items_.insert(items_.end(), others.items_.begin(), others.items_.end());
}

bool Diagnostics::HasErrors() const {
  return std::any_of(items_.begin(), items_.end(),
                     [](const Diagnostic& item) { return item.severity == Severity::kError; });
}

std::vector<Diagnostic> Diagnostics::ByWeight() const {
  std::vector<Diagnostic> sorted = items_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.severity, WeightOf(a)) < std::pair(b.severity, WeightOf(b));
  });
  return sorted;
}

std::string Diagnostics::Format() const {
  std::vector<const Diagnostic*> sorted;
  for (const Diagnostic& item : items_) sorted.push_back(&item);
  std::set<std::string_view> faulty;
  for (const Diagnostic& item : items_)
    if (item.severity == Severity::kError) faulty.insert(Name(item.place));
  const auto rank = [&](const Diagnostic* item) {
    return std::tuple(!faulty.contains(Name(item->place)), std::string_view(Name(item->place)), item->severity,
                      WeightOf(*item), item->place.line);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Diagnostic* a, const Diagnostic* b) { return rank(a) < rank(b); });
  std::string text;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(),
                                   [&](const Diagnostic* item) { return Name(item->place) != Name((*first)->place); });
    const auto shown = first + std::min<std::ptrdiff_t>(last - first, kMostPerFile);
    for (auto item = first; item != shown; ++item) AddLine(fourpost::Format(**item), text);
    if (shown != last) AddLine(Name((*first)->place) + ": " + std::to_string(last - shown) + " more", text);
    first = last;
  }
  return text;
}

FaultyInput::FaultyInput(Diagnostics diagnostics)
    : std::runtime_error(diagnostics.Format()), diagnostics_(std::move(diagnostics)) {}

void Refuse(const Finding& finding, Place place, const std::vector<std::string>& words) {
  Diagnostics diagnostics;
  diagnostics.Report(finding, std::move(place), words);
  throw FaultyInput(std::move(diagnostics));
}

}  // namespace fourpost
