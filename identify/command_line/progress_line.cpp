#include "identify/command_line/progress_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "analysis/text/text_table.h"
#include "analysis/text/text_width.h"

namespace fourpost {
namespace {

constexpr double kTerminalInterval_s = 0.1;
constexpr double kPlainInterval_s = 2;

double Seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

/// A terminal that can clear a line.
bool IsTerminal() {
  const char* const kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
}

/// Of the terminal now: users change it.
std::size_t Columns() {
  constexpr std::size_t kUsual = 80;
  winsize size = {};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : kUsual;
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(IsTerminal()), start_(Clock::now()), shown_(start_) {}

ProgressLine::~ProgressLine() {
  if (line_open_) std::fputc('\n', stderr);
}

void ProgressLine::Show(const std::string& text) {
  const Clock::time_point now = Clock::now();
  if (Seconds(now - shown_) < (terminal_ ? kTerminalInterval_s : kPlainInterval_s)) return;
  shown_ = now;
  line_open_ = terminal_;
  // Return to the line's start, and clear what a longer text left behind; a full line would lose its last character
  // by that.
  if (terminal_) std::fprintf(stderr, "\r%s\033[K", CutToWidth(text, Columns() - 1).c_str());
  else std::fprintf(stderr, "%s\n", text.c_str());
  std::fflush(stderr);
}

void ProgressLine::ShowNext(const std::string& text) {
  if (seconds() < kPlainInterval_s) return;
  shown_ = start_;
  Show(text);
}

double ProgressLine::seconds() const { return Seconds(Clock::now() - start_); }

}  // namespace fourpost
