#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <functional>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/files/output_folder.h"
#include "analysis/text/diagnostics.h"
#include "analysis/text/nearest.h"
#include "analysis/text/shortened.h"
#include "analysis/text/table_width.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/print.h"
#include "identify/command_line/program.h"
#include "identify/command_line/terminal.h"
#include "vehicles/multibody/simulation_error.h"

namespace {

using namespace fourpost;

/// Whether all that is wrong is the values of options: findings are about "--amplitude" then, else about a file.
bool IsUsage(const Diagnostics& diagnostics) {
  const std::vector<Diagnostic>& items = diagnostics.items();
  return std::all_of(items.begin(), items.end(), [](const Diagnostic& item) {
    return item.severity == Severity::kWarning || !item.place.option.empty();
  });
}

int Guarded(const std::function<int()>& run) {
  try {
    return run();
  } catch (const FaultyInput& error) {
    Tell(error.diagnostics());
    return IsUsage(error.diagnostics()) ? kUsage : kUnreadableInput;
  } catch (const OutputError& error) {
    Tell(error);
    return kCannotWrite;
  } catch (const SimulationError& error) {
    Tell(error);
    return kAllSimulationsFailed;
  } catch (const std::bad_alloc&) {
    Tell(kOutOfMemoryFound);
    return kOutOfMemory;
  } catch (const std::exception& error) {
    Tell(kDefectFound, {}, {error.what()});
    return kDefect;
  }
}

/// Of a command its options; of the program its commands, too.
void AddOptionNames(const CLI::App& app, std::vector<std::string>& names) {
  for (const CLI::Option* option : app.get_options()) names.push_back(option->get_name());
  for (const CLI::App* part : app.get_subcommands({})) {
    // Groups of options have no name.
    if (part->get_name().empty()) AddOptionNames(*part, names);
    else names.push_back(part->get_name());
  }
}

/// "fourpost fit"
std::string CalledAs(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  return given.empty() ? "fourpost" : "fourpost " + given.front()->get_name();
}

/// Words that are no options, arguments or commands, and what they were likely meant to be.
void TellUnknown(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  std::vector<std::string> known;
  AddOptionNames(given.empty() ? app : *given.front(), known);
  const std::vector<std::string> words = app.remaining(true);
  const auto is_option = [](const std::string& word) { return word.starts_with("-"); };
  const bool has_option = std::any_of(words.begin(), words.end(), is_option);
  Diagnostics faults;
  for (const std::string& word : words) {
    // Else it is an unknown option's value.
    if (has_option && !is_option(word)) continue;
    const std::string name = word.substr(0, word.find('='));
    const std::string shown = Shortened(name, 200);
    if (const auto near = NearestName(name, known))
      faults.Report(kArgumentMisspelt, {}, {CalledAs(app), shown, std::string(*near)});
    else faults.Report(kArgumentUnknown, {}, {CalledAs(app), shown, CalledAs(app)});
    // The words after an unknown command are its own.
    if (given.empty() && !has_option) break;
  }
  Tell(faults);
}

/// A fault that CLI11 reports as "--threads: Value 5000 not in range", at its option.
void TellUsage(const CLI::App& app, const std::string& fault) {
  constexpr std::string_view kSeparator = ": ";
  const std::size_t colon = fault.find(kSeparator);
  const std::string name = fault.substr(0, colon);
  const bool has_option = colon != std::string::npos && name.find(' ') == std::string::npos;
  Tell(kUsageWrong, has_option ? Place::Option(name) : Place{},
       {has_option ? fault.substr(colon + kSeparator.size()) : fault, CalledAs(app)});
}

/// What --help or --version asked for. Throws OutputError.
int PrintHelp(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out;
  app.exit(error, out, out);
  PrintText(out.str());
  return kGood;
}

}  // namespace

int main(int argc, char** argv) {
  // A limit of the size of files then is an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  if (IsTerminal(STDOUT_FILENO)) SetTableWidth(TerminalColumns(STDOUT_FILENO));
  Program program;
  CLI::App& app = program.app();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool is_help = error.get_exit_code() == 0;
    if (is_help) return Guarded([&] { return PrintHelp(app, error); });
    if (app.remaining(true).empty()) TellUsage(app, error.what());
    else TellUnknown(app);
    return kUsage;
  } catch (const FaultyInput& error) {
    Tell(error.diagnostics());
    return kUsage;
  }
  return Guarded([&] { return program.RunCommand(); });
}
