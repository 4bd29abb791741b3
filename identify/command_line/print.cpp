#include "identify/command_line/print.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "analysis/files/output_folder.h"

namespace fourpost {

std::string WithoutControls(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // Those of Latin-1 are two bytes in UTF-8.
    const bool is_second = i > 0 && text[i - 1] == '\xC2' && byte >= 0x80 && byte < 0xA0;
    if (is_second) text[i - 1] = '?';
    if (is_second || byte == 0x7F || (byte < 0x20 && byte != '\n' && byte != '\t')) text[i] = '?';
  }
  return text;
}

void Tell(const Diagnostics& diagnostics) {
  if (!diagnostics.items().empty()) std::fprintf(stderr, "%s\n", WithoutControls(diagnostics.Format()).c_str());
}

void Print(const std::string& text) {
  if (std::fputs(WithoutControls(text).c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return;
  throw OutputError(std::string("cannot write the result to stdout: ") + std::strerror(errno));
}

}  // namespace fourpost
