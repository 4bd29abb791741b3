#include "identify/command_line/progress_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "identify/command_line/text_table.h"
#include "identify/command_line/text_width.h"

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

std::string TimeLeft(double share, double seconds, double since_s) {
  // What begins is not yet what goes on.
  if (!(share > 0.02) || seconds < 1) return "";
  const double left = std::max(0.0, seconds * (1 / share - 1) - since_s);
  char text[48];
  std::snprintf(text, sizeof text, left < 120 ? ", about %.0f s left" : ", about %.0f min left",
                left < 120 ? left : left / 60);
  return text;
}

std::string Rate(double done, double seconds, const std::string& what) {
  if (!(done > 0) || seconds < 0.5) return "";
  const double per_second = done / seconds;
  const bool is_slow = per_second < 0.1;
  return ", " + Rounded(is_slow ? 60 * per_second : per_second, 2) + " " + what +
         (is_slow ? " per minute" : " per second");
}

}  // namespace fourpost
