#include "identify/command_line/finding_list.h"

#include <string_view>

// Those of the public headers, which the program itself does not use.
#include "identify/api/findings.h"

namespace fourpost {
namespace {

const char* SeverityName(const Finding& finding) {
  return finding.severity() == Severity::kError ? "error" : "warning";
}

/// With "..." for what is known only of one that was made.
std::string WithDots(std::string_view text) {
  std::string shown(text);
  for (std::size_t at = shown.find("{}"); at != std::string::npos; at = shown.find("{}", at))
    shown.replace(at, 2, "...");
  return shown;
}

/// As a cell; what stands between backquotes is code.
std::string MarkdownCell(std::string_view text) {
  std::string cell;
  bool is_code = false;
  for (const char c : WithDots(text)) {
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
      "Ids do not change, words may. `...` stands for names and numbers.\n\n"
      "An error: the input cannot be used. A warning: it can, but it or the result is probably wrong.\n\n"
      "| id | severity | finding | remedy |\n|---|---|---|---|\n";
  for (const auto& [id, finding] : AllFindings())
    text += "| `" + std::string(id) + "` | " + SeverityName(*finding) + " | " + MarkdownCell(finding->text()) + " | " +
            MarkdownCell(finding->remedy()) + " |\n";
  return text;
}

std::string FindingText(const Finding& finding) {
  std::string text =
      std::string(finding.id()) + ", " + SeverityName(finding) + "\n  " + WithDots(finding.text()) + "\n";
  if (!finding.remedy().empty()) text += "Remedy\n  " + WithDots(finding.remedy()) + "\n";
  return text;
}

}  // namespace fourpost
