#include "identify/command_line/finding_list.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

// Those of the public headers, which the program itself does not use.
#include "identify/api/findings.h"

namespace fourpost {
namespace {

const char* SeverityName(const Finding& finding) {
  return finding.severity() == Severity::kError ? "error" : "warning";
}

/// Whether a number stands before this.
bool IsUnit(std::string_view text) {
  constexpr std::array<std::string_view, 13> kUnits = {" %",  " Hz", " s ",      " mm",    " m ",       " kg", " N ",
                                                       " dB", " sd", " degrees", " times", " samples,", " ms"};
  return std::any_of(kUnits.begin(), kUnits.end(), [&](std::string_view unit) { return text.starts_with(unit); });
}

/// What stands for a word that is known only of a finding that was made, by what is beside it.
std::string_view StandIn(std::string_view before, std::string_view after) {
  if (before.ends_with('\'') && after.starts_with('\'')) return "NAME";
  return IsUnit(after) ? "N" : "...";
}

/// Whether what is between these is one more word, which brings its own blank: behind a letter or a quote that closes.
bool EndsAWord(std::string_view text, std::string_view after) {
  if (text.empty()) return false;
  const char last = text.back();
  if (last == '\'' || last == '`') return !after.starts_with(last) && !after.starts_with(' ');
  return std::isalnum(static_cast<unsigned char>(last)) != 0;
}

/// With stand-ins for words; neighbours are one.
std::string WithStandIns(std::string_view text) {
  constexpr std::string_view kWord = "{}";
  std::string shown;
  for (;;) {
    const std::size_t at = text.find(kWord);
    shown += text.substr(0, at);
    if (at == std::string_view::npos) return shown;
    text.remove_prefix(at);
    while (text.starts_with(kWord)) text.remove_prefix(kWord.size());
    if (EndsAWord(shown, text)) shown += ' ';
    shown += StandIn(shown, text);
  }
}

/// As a cell; what stands between backquotes is code.
std::string MarkdownCell(std::string_view text) {
  std::string cell;
  bool is_code = false;
  for (const char c : WithStandIns(text)) {
    is_code = is_code != (c == '`');
    const bool is_special = c == '|' || (!is_code && (c == '<' || c == '*' || c == '_' || c == '[' || c == '\\'));
    if (is_special) cell += '\\';
    cell += c;
  }
  return cell;
}

}  // namespace

std::string FindingsMarkdown() {
  std::string text =
      "# Findings\n\n"
      "All errors and warnings of fourpost. A message ends with its id in brackets, which `fourpost help ID` "
      "explains.\n"
      "Ids do not change, words may. `NAME`, `N` and `...` stand for names, numbers and what a message adds.\n\n"
      "An error: the input cannot be used. A warning: it can, but it or the result is probably wrong.\n\n"
      "| id | severity | finding | remedy |\n|---|---|---|---|\n";
  for (const auto& [id, finding] : AllFindings())
    text += "| `" + std::string(id) + "` | " + SeverityName(*finding) + " | " + MarkdownCell(finding->text()) + " | " +
            MarkdownCell(finding->remedy()) + " |\n";
  return text;
}

std::string FindingText(const Finding& finding) {
  std::string text =
      std::string(finding.id()) + ", " + SeverityName(finding) + "\n  " + WithStandIns(finding.text()) + "\n";
  if (!finding.remedy().empty()) text += "Remedy\n  " + WithStandIns(finding.remedy()) + "\n";
  return text;
}

}  // namespace fourpost
