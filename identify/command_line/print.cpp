#include "identify/command_line/print.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "identify/command_line/findings.h"
#include "identify/command_line/output_file.h"

namespace fourpost {
namespace {

void TellText(const std::string& text) { std::fprintf(stderr, "%s\n", WithoutControls(text).c_str()); }

}  // namespace

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
  if (!diagnostics.items().empty()) TellText(diagnostics.Format());
}

void Tell(const Finding& finding, Place place, const std::vector<std::string>& words) {
  Diagnostics one;
  one.Report(finding, std::move(place), words);
  Tell(one);
}

void Tell(const OutputError& error) { TellText(error.what()); }

void Print(const std::string& text) {
  if (std::fputs(WithoutControls(text).c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return;
  RefuseToWrite(kStdoutNotWritten, {}, {std::strerror(errno)});
}

}  // namespace fourpost
