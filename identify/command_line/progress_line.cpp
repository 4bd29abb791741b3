#include "identify/command_line/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

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
  // Return to the line's start, and clear what a longer text left behind.
  std::fprintf(stderr, terminal_ ? "\r%s\033[K" : "%s\n", text.c_str());
  std::fflush(stderr);
}

void ProgressLine::ShowNext(const std::string& text) {
  if (seconds() < kPlainInterval_s) return;
  shown_ = start_;
  Show(text);
}

double ProgressLine::seconds() const { return Seconds(Clock::now() - start_); }

std::string TimeLeft(double share, double seconds) {
  // What begins is not yet what goes on.
  if (!(share > 0.02) || seconds < 1) return "";
  const double left = seconds * std::max(0.0, 1 / share - 1);
  char text[48];
  std::snprintf(text, sizeof text, left < 120 ? ", about %.0f s left" : ", about %.0f min left",
                left < 120 ? left : left / 60);
  return text;
}

}  // namespace fourpost
