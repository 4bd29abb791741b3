#include "identify/command_line/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace fourpost {
namespace {

std::string_view Variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

bool IsTerminal(int descriptor) {
  const std::string_view kind = Variable("TERM");
  return isatty(descriptor) != 0 && !kind.empty() && kind != "dumb";
}

std::size_t TerminalColumns(int descriptor) {
  constexpr std::size_t kUsual = 80;
  const std::string_view given = Variable("COLUMNS");
  std::size_t columns = 0;
  std::from_chars(given.data(), given.data() + given.size(), columns);
  if (columns > 0) return columns;
  winsize size = {};
  const bool is_known = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : kUsual;
}

bool TakesColours(int descriptor) { return IsTerminal(descriptor) && Variable("NO_COLOR").empty(); }

}  // namespace fourpost
