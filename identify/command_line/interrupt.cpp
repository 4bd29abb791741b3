#include "identify/command_line/interrupt.h"

#include <csignal>

namespace fourpost {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void AskToStop(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void CatchInterrupts() {
  std::signal(SIGINT, AskToStop);
  std::signal(SIGTERM, AskToStop);
}

bool Interrupted() { return interrupted != 0; }

}  // namespace fourpost
