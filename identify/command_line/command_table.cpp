#include "identify/command_line/command_table.h"

#include <algorithm>

namespace fourpost {
namespace {

/// Of a type such as "TEXT:{up,down}".
std::vector<std::string> Words(const std::string& type) {
  std::vector<std::string> words;
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return words;
  for (std::size_t at = open + 1; at < close;) {
    const std::size_t end = std::min(type.find(',', at), close);
    words.push_back(type.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

OptionRow RowOf(const CLI::Option& option) {
  OptionRow row;
  row.is_argument = !option.nonpositional();
  row.name = row.is_argument ? option.get_name(true) : option.get_name();
  if (!option.get_snames().empty()) row.short_name = "-" + option.get_snames().front();
  row.help = option.get_description();
  row.is_required = option.get_required();
  row.takes_value = option.get_items_expected_max() > 0;
  row.is_list = option.get_items_expected_max() > 1;
  row.words = Words(option.get_type_name());
  return row;
}

/// Groups of options are commands without a name.
void AddOptionsOf(const CLI::App& app, std::vector<OptionRow>& rows) {
  for (const CLI::Option* option : app.get_options()) rows.push_back(RowOf(*option));
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; })) AddOptionsOf(*group, rows);
}

std::string ExamplesOf(const CLI::App& command) {
  const std::string footer = command.get_footer();
  return footer.substr(std::min(footer.find('\n'), footer.size() - 1) + 1);
}

}  // namespace

std::vector<CommandRow> CommandTable(const CLI::App& app) {
  std::vector<CommandRow> table;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    CommandRow row = {command->get_name(), command->get_description(), ExamplesOf(*command), {}};
    AddOptionsOf(*command, row.options);
    table.push_back(std::move(row));
  }
  return table;
}

}  // namespace fourpost
