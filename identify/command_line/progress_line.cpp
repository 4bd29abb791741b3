#include "identify/command_line/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "analysis/text/text_table.h"
#include "analysis/text/text_width.h"
#include "identify/command_line/terminal.h"

namespace fourpost {
namespace {

constexpr double kTerminalInterval_s = 0.1;
constexpr double kPlainInterval_s = 2;

double Seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

ProgressLine::ProgressLine(Clock::time_point start)
    : terminal_(IsTerminal(STDERR_FILENO)), start_(start), shown_(Clock::now()) {}

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
  if (terminal_) std::fprintf(stderr, "\r%s\033[K", CutToWidth(text, TerminalColumns(STDERR_FILENO) - 1).c_str());
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
