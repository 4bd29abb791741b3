#include "identify/command_line/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analysis/text/text_width.h"
#include "identify/command_line/terminal.h"

namespace fourpost {
namespace {

constexpr double kTerminalInterval_s = 0.1;
constexpr double kPlainInterval_s = 2;

double Seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

ProgressLine::ProgressLine(Clock::time_point start, Clock::duration beat)
    : terminal_(IsTerminal(STDERR_FILENO)), beat_(beat), start_(start), shown_(Clock::now()) {}

ProgressLine::~ProgressLine() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_all();
  if (beating_.joinable()) beating_.join();
  if (line_open_) std::fputc('\n', stderr);
}

void ProgressLine::Show(const std::string& text) {
  const std::lock_guard lock(mutex_);
  text_ = text;
  if (!beating_.joinable()) beating_ = std::thread([this] { Beat(); });
  const Clock::time_point now = Clock::now();
  if (Seconds(now - shown_) < (terminal_ ? kTerminalInterval_s : kPlainInterval_s)) return;
  Print(text);
}

void ProgressLine::ShowNext(const std::string& text) {
  if (seconds() < kPlainInterval_s) return;
  {
    const std::lock_guard lock(mutex_);
    shown_ = start_;
  }
  Show(text);
}

double ProgressLine::seconds() const { return Seconds(Clock::now() - start_); }

void ProgressLine::Beat() {
  std::unique_lock lock(mutex_);
  while (!ended_) {
    if (wake_.wait_until(lock, shown_ + beat_, [this] { return ended_; })) return;
    if (Clock::now() >= shown_ + beat_) Print(std::to_string(std::lround(seconds())) + " s so far, " + text_);
  }
}

void ProgressLine::Print(const std::string& text) {
  shown_ = Clock::now();
  line_open_ = terminal_;
  // Return to the line's start, and clear what a longer text left behind; a full line would lose its last character
  // by that.
  if (terminal_) std::fprintf(stderr, "\r%s\033[K", CutToWidth(text, TerminalColumns(STDERR_FILENO) - 1).c_str());
  else std::fprintf(stderr, "%s\n", text.c_str());
  std::fflush(stderr);
}

}  // namespace fourpost
