#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace fourpost {

/// An option or argument of a command, as its help shows it.
struct OptionRow {
  /// "--output", and "-o" or empty; of an argument its name in capitals.
  std::string name;
  std::string short_name;
  std::string help;
  bool is_argument = false;
  bool is_required = false;
  bool takes_value = false;
  /// An argument that may be given several times.
  bool is_list = false;
  /// The words that it takes; empty where it takes others.
  std::vector<std::string> words;
};

struct CommandRow {
  std::string name;
  std::string help;
  /// One line each, indented.
  std::string examples;
  std::vector<OptionRow> options;
};

/// All commands of the program, in the order of its help.
std::vector<CommandRow> CommandTable(const CLI::App& app);

}  // namespace fourpost
