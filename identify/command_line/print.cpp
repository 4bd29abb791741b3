#include "identify/command_line/print.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <utility>

#include "identify/command_line/findings.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/terminal.h"
#include "identify/command_line/wrapped_text.h"

namespace fourpost {
namespace {

/// A finding's line with its severity in colour.
std::string Coloured(const std::string& line) {
  const std::size_t error = line.find("error: ");
  const std::size_t warning = line.find("warning: ");
  const std::size_t at = std::min(error, warning);
  if (at == std::string::npos) return line;
  const std::size_t end = line.find(' ', at);
  const char* const colour = at == error ? "\033[1;31m" : "\033[1;33m";
  return line.substr(0, at) + colour + line.substr(at, end - at) + "\033[0m" + line.substr(end);
}

void TellText(const std::string& text) {
  std::istringstream lines(WithoutControls(text));
  const bool is_coloured = TakesColours(STDERR_FILENO);
  for (std::string line; std::getline(lines, line);)
    std::fprintf(stderr, "%s\n", (is_coloured ? Coloured(line) : line).c_str());
}

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

void Tell(const SimulationError& error) {
  const std::string text = error.what();
  // With the id of its own finding at the end.
  if (text.ends_with(']')) TellText("error: " + text);
  else Tell(kSimulationStopped, {}, {text});
}

void PrintText(const std::string& text) {
  Print(IsTerminal(STDOUT_FILENO) ? Wrapped(text, TerminalColumns(STDOUT_FILENO)) : text);
}

void Print(const std::string& text) {
  if (std::fputs(WithoutControls(text).c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return;
  RefuseToWrite(kStdoutNotWritten, {}, {std::strerror(errno)});
}

}  // namespace fourpost
