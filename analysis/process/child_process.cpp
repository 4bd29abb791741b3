#include "analysis/process/child_process.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

namespace fourpost {
namespace {

constexpr unsigned kPatience_s = 60;

/// Never returns; exit handlers and buffers are the parent's.
[[noreturn]] void Answer(const std::function<std::string()>& work, int to) {
  // Crashes are expected here: no handler that a debugger or sanitizer set up reports them.
  for (const int crash : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE}) signal(crash, SIG_DFL);
  signal(SIGINT, SIG_DFL);
  alarm(kPatience_s);
  const std::string text = work();
  for (std::string_view rest = text; !rest.empty();) {
    const ssize_t written = write(to, rest.data(), rest.size());
    if (written < 0) _exit(1);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  _exit(0);
}

std::string AllOf(int from) {
  std::string text;
  std::array<char, 65536> piece;
  for (;;) {
    const ssize_t count = read(from, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

std::optional<std::string> AnswerOfChild(const std::function<std::string()>& work) {
  std::array<int, 2> ends;
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category());
  const pid_t child = fork();
  if (child == 0) Answer(work, ends[1]);
  const std::error_code failure(errno, std::generic_category());
  close(ends[1]);
  std::string text = child > 0 ? AllOf(ends[0]) : "";
  close(ends[0]);
  if (child < 0) throw std::system_error(failure);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace fourpost
