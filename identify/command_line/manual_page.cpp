#include "identify/command_line/manual_page.h"

#include <array>
#include <utility>

namespace fourpost {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 10> kExitCodes = {{
    {"0", "Success."},
    {"1",
     "Done with reservations: a fit did not converge, or its model does not explain the data; some frequencies have no "
     "answer."},
    {"2", "An option is unknown or has a value that cannot be used."},
    {"3", "A file cannot be used; all its errors are listed at once."},
    {"4", "Every simulation failed."},
    {"5", "A result cannot be written."},
    {"70", "A defect of fourpost."},
    {"71", "Out of memory."},
    {"75", "A batch is not complete, for example because its scheduler went away; run it again."},
    {"130", "Interrupted; response, simulate, fit and compare end with what they have."},
}};

/// Hyphens that stay hyphens, and no line that begins like a request.
std::string Roff(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    if (c == '\\') roff += "\\e";
    else if (c == '-') roff += "\\-";
    else if ((c == '.' || c == '\'') && (roff.empty() || roff.back() == '\n')) roff += std::string("\\&") + c;
    else roff += c;
  }
  return roff;
}

std::string Synopsis(const CommandRow& command) {
  std::string text = ".B fourpost " + Roff(command.name) + "\n";
  for (const OptionRow& option : command.options)
    if (option.is_argument) text += ".I " + Roff(option.name + (option.is_list ? "..." : "")) + "\n";
  return text + ".RI [ option ...]\n";
}

std::string Item(const OptionRow& option) {
  std::string text = ".TP\n";
  if (option.is_argument) text += ".I " + Roff(option.name) + "\n";
  else {
    text += ".B " + (option.short_name.empty() ? "" : Roff(option.short_name) + ", ") + Roff(option.name);
    text += option.takes_value ? " \\fIVALUE\\fR\n" : "\n";
  }
  text += Roff(option.help);
  if (!option.words.empty() && !option.is_argument) {
    text += "\nOne of";
    for (const std::string& word : option.words) text += " " + Roff(word);
    text += ".";
  }
  return text + "\n";
}

}  // namespace

std::string ManualPage(const std::vector<CommandRow>& commands) {
  std::string text =
      ".TH FOURPOST 1 \"\" \"fourpost " FOURPOST_VERSION
      "\"\n.SH NAME\nfourpost \\- identify vehicle suspension models from rig tests\n.SH SYNOPSIS\n"
      ".B fourpost\n.I COMMAND\n.RI [ option ...]\n.SH DESCRIPTION\n"
      "fourpost estimates masses, inertias and the rates of springs, tyres and dampers of a vehicle, which a text file "
      "describes, from recordings of a four\\-post rig or a damper bench, and reports how well the data determine "
      "each.\n"
      "Results go to stdout, progress and messages to stderr. Numbers carry units.\n.SH COMMANDS\n";
  for (const CommandRow& command : commands) {
    text += ".SS " + Roff(command.name) + "\n" + Roff(command.help) + ".\n.PP\n" + Synopsis(command);
    for (const OptionRow& option : command.options) text += Item(option);
    text += ".PP\n.nf\n" + Roff(command.examples) + "\n.fi\n";
  }
  text += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : kExitCodes) text += std::string(".TP\n.B ") + code + "\n" + Roff(meaning) + "\n";
  return text;
}

}  // namespace fourpost
