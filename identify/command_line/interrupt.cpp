#include "identify/command_line/interrupt.h"

#include <unistd.h>

#include <csignal>
#include <ctime>
#include <string_view>

namespace fourpost {
namespace {

volatile std::sig_atomic_t interrupted = 0;
volatile std::time_t first_time = 0;

void AskToStop(int signal) {
  const std::time_t now = std::time(nullptr);
  if (interrupted == 0) {
    interrupted = 1;
    first_time = now;
    // Safe in a handler, unlike what formats.
    const std::string_view message =
        signal == SIGINT ? "\nstopping; another Ctrl-C in two seconds or later ends at once, without results\n"
                         : "\nstopping; another such signal in two seconds or later ends at once, without results\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, message.data(), message.size());
  } else if (now - first_time > 1) {
    // Programs such as timeout(1) send one interrupt twice, to the process and to its group.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void CatchInterrupts() {
  std::signal(SIGINT, AskToStop);
  std::signal(SIGTERM, AskToStop);
}

bool Interrupted() { return interrupted != 0; }

}  // namespace fourpost
