#include "identify/command_line/wrapped_text.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "analysis/text/text_width.h"

namespace fourpost {
namespace {

constexpr std::size_t kNone = std::string_view::npos;

/// Where a line's last column begins, behind two blanks or more; its indent where it has one column.
std::size_t LastColumn(std::string_view line) {
  const std::size_t gap = line.rfind("  ");
  return gap == kNone ? 0 : gap + 2;
}

/// What stands before the last column, where that leaves half of the width for it.
std::size_t Hang(std::string_view line, std::size_t width) {
  const std::size_t last = LastColumn(line);
  return Width(line.substr(0, last)) <= width / 2 ? last : std::min(line.find_first_not_of(' '), width / 2);
}

std::string WrappedLine(const std::string& line, std::size_t width) {
  const std::size_t hang = Hang(line, width);
  const std::string indent(Width(std::string_view(line).substr(0, hang)), ' ');
  std::string text;
  std::string row = line.substr(0, hang);
  std::istringstream words(line.substr(hang));
  for (std::string word; words >> word;) {
    const bool is_first = row.size() <= indent.size() || row.find_last_not_of(' ') < hang;
    if (!is_first && Width(row) + 1 + Width(word) > width) {
      text += row + '\n';
      row = indent + word;
    } else {
      row += (is_first ? "" : " ") + word;
    }
  }
  return text + row;
}

bool IsCommand(std::string_view line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first != kNone && first > 0 && line.substr(first).starts_with("fourpost ");
}

}  // namespace

std::string Wrapped(const std::string& text, std::size_t width) {
  std::string wrapped;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = text.substr(from, end - from);
    wrapped += Width(line) <= width || IsCommand(line) ? line : WrappedLine(line, width);
    if (end < text.size()) wrapped += '\n';
    from = end + 1;
  }
  return wrapped;
}

}  // namespace fourpost
