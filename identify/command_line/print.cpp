#include "identify/command_line/print.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "analysis/output_folder.h"

namespace fourpost {

void Tell(const Diagnostics& diagnostics) {
  if (!diagnostics.items().empty()) std::fprintf(stderr, "%s\n", diagnostics.Format().c_str());
}

void Print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return;
  throw OutputError(std::string("cannot write the result to stdout: ") + std::strerror(errno));
}

}  // namespace fourpost
