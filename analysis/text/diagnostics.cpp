#include "analysis/text/diagnostics.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "analysis/text/enumeration.h"
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

/// Which words of a finding's text stand in quotes and so are names.
std::vector<bool> AreNames(const Diagnostic& item) {
  std::vector<bool> names(item.words.size());
  const auto finding = AllFindings().find(item.id);
  if (finding == AllFindings().end()) return names;
  const std::string_view text = finding->second->text();
  std::size_t word = 0;
  for (std::size_t at = text.find("{}"); at != std::string_view::npos && word < names.size();
       at = text.find("{}", at + 2), ++word)
    names[word] = at > 0 && text[at - 1] == '\'' && text.substr(at + 2).starts_with('\'');
  return names;
}

bool HasName(const Diagnostic& item) {
  const std::vector<bool> names = AreNames(item);
  return std::find(names.begin(), names.end(), true) != names.end();
}

/// A word that continues a sentence, ", did you mean 'a'?", on its own.
std::string AsItself(std::string_view word) {
  const std::size_t begin = word.find_first_not_of(",;: ");
  return std::string(begin == std::string_view::npos ? std::string_view() : word.substr(begin));
}

/// Of one of a group: "'b' of 'run2' (words that differ from those of the first, line 4)"; without a name that differs
/// the words alone.
std::string LikewiseText(const Diagnostic& item, const Diagnostic& first, const std::vector<bool>& differ) {
  const std::vector<bool> names = AreNames(item);
  std::string name;
  std::string others;
  for (std::size_t i = 0; i < std::min(item.words.size(), differ.size()); ++i) {
    if (!differ[i]) continue;
    if (names[i]) name += (name.empty() ? "'" : " of '") + item.words[i] + "'";
    else if (const std::string word = AsItself(item.words[i]); item.words[i] != first.words[i] && !word.empty())
      others += (others.empty() ? "" : ", ") + word;
  }
  if (item.place.line != first.place.line && item.place.line > 0)
    others += (others.empty() ? "line " : ", line ") + std::to_string(item.place.line);
  if (name.empty() || others.empty()) return name + others;
  return name + " (" + others + ")";
}

/// The first in full; of the others what they are of. Repeated ones go.
std::string MessageOfAll(const std::vector<const Diagnostic*>& group) {
  const Diagnostic& first = *group.front();
  std::vector<bool> differ(first.words.size());
  for (const Diagnostic* item : group)
    for (std::size_t i = 0; i < std::min(differ.size(), item->words.size()); ++i)
      differ[i] = differ[i] || item->words[i] != first.words[i];
  constexpr std::size_t kMostNamed = 24;
  std::vector<std::string> others;
  std::set<std::string> known;
  for (const Diagnostic* item : group) {
    if (item->words == first.words) continue;
    std::string text = LikewiseText(*item, first, differ);
    if (!known.insert(text).second) continue;
    if (others.size() < kMostNamed) others.push_back(std::move(text));
  }
  if (known.size() > kMostNamed) others.push_back(std::to_string(known.size() - kMostNamed) + " more");
  return first.message + (others.empty() ? "" : "; likewise " + Enumeration(others));
}

/// Names beyond what a finding is of, "'a' of 'run'": those of its remedy.
std::string FurtherNames(const Diagnostic& item) {
  constexpr int kOwn = 2;
  const std::vector<bool> names = AreNames(item);
  std::string further;
  int count = 0;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] && ++count > kOwn) further += item.words[i] + '\n';
  return further;
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
  for (const std::string& word : words) items_.back().words.push_back(Short(word));
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
  std::vector<Diagnostic> sorted = Grouped();
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.severity, WeightOf(a)) < std::pair(b.severity, WeightOf(b));
  });
  return sorted;
}

std::vector<Diagnostic> Diagnostics::Grouped() const {
  std::vector<std::vector<const Diagnostic*>> groups;
  std::map<std::tuple<std::string_view, Severity, std::string_view, int, std::string>, std::size_t> places;
  for (const Diagnostic& item : items_) {
    const int line = item.severity == Severity::kError ? item.place.line : 0;
    const auto [found, is_new] =
        places.try_emplace({item.id, item.severity, Name(item.place), line, FurtherNames(item)}, groups.size());
    if (is_new || !HasName(item)) groups.emplace_back();
    groups[is_new || !HasName(item) ? groups.size() - 1 : found->second].push_back(&item);
  }
  std::vector<Diagnostic> result;
  for (const std::vector<const Diagnostic*>& group : groups) {
    result.push_back(*group.front());
    if (group.size() > 1) result.back().message = Short(MessageOfAll(group));
  }
  return result;
}

std::string Diagnostics::Format() const {
  const std::vector<Diagnostic> grouped = Grouped();
  std::vector<const Diagnostic*> sorted;
  for (const Diagnostic& item : grouped) sorted.push_back(&item);
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
