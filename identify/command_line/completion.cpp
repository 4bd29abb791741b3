#include "identify/command_line/completion.h"

#include <algorithm>

namespace fourpost {
namespace {

std::string Joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> Names(const std::vector<CommandRow>& commands) {
  std::vector<std::string> names;
  for (const CommandRow& command : commands) names.push_back(command.name);
  return names;
}

std::vector<std::string> Spellings(const OptionRow& option) {
  if (option.short_name.empty()) return {option.name};
  return {option.short_name, option.name};
}

std::vector<std::string> Flags(const CommandRow& command) {
  std::vector<std::string> flags;
  for (const OptionRow& option : command.options)
    if (!option.is_argument)
      for (const std::string& spelling : Spellings(option)) flags.push_back(spelling);
  return flags;
}

std::vector<std::string> WordsOfArguments(const CommandRow& command) {
  std::vector<std::string> words;
  for (const OptionRow& option : command.options)
    if (option.is_argument) words.insert(words.end(), option.words.begin(), option.words.end());
  return words;
}

/// Within single quotes of a shell.
std::string Quoted(std::string text, const std::string& quote_as) {
  for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at + quote_as.size()))
    text.replace(at, 1, quote_as);
  return "'" + text + "'";
}

std::string Bash(const std::vector<CommandRow>& commands) {
  std::string text =
      "# bash completion of fourpost\n"
      "_fourpost() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options= words=\n"
      // bash takes the sign of --engine=full for a word of its own.
      "  if [ \"$word\" = = ]; then word=\n"
      "  elif [ \"$before\" = = ]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W '" +
      Joined(Names(commands), " ") +
      " --help --version' -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case ${COMP_WORDS[1]} in\n";
  for (const CommandRow& command : commands) {
    text += "    " + command.name + ")\n      options='" + Joined(Flags(command), " ") + "'\n";
    if (const auto words = WordsOfArguments(command); !words.empty())
      text += "      words='" + Joined(words, " ") + "'\n";
    for (const OptionRow& option : command.options)
      if (!option.is_argument && !option.words.empty())
        text += "      [ \"$before\" = " + option.name + " ] && options= words='" + Joined(option.words, " ") + "'\n";
    text += "      ;;\n";
  }
  return text +
         "  esac\n"
         "  local list=${word%\"${word##*,}\"}\n"
         "  if [ -n \"$words\" ] && [[ $word != -* ]]; then\n"
         "    COMPREPLY=($(compgen -P \"$list\" -W \"$words\" -- \"${word##*,}\"))\n"
         "  elif [[ $word == -* ]]; then COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
         // Else of files, which bash itself knows to quote.
         "  fi\n"
         "}\n"
         "complete -o default -F _fourpost fourpost\n";
}

/// In _arguments a colon ends a description, and brackets hold it.
std::string ZshHelp(const std::string& help) {
  std::string text;
  for (const char c : help) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}

std::string ZshOption(const OptionRow& option) {
  const std::string action = option.words.empty() ? "_files" : "(" + Joined(option.words, " ") + ")";
  const std::string what = ZshHelp(option.help);
  if (option.is_argument) return "        " + Quoted("*:" + option.name + ":" + action, "'\\''") + " \\\n";
  std::string text;
  for (const std::string& spelling : Spellings(option))
    text += "        " +
            Quoted("*" + spelling + "[" + what + "]" + (option.takes_value ? ":value:" + action : ""), "'\\''") +
            " \\\n";
  return text;
}

std::string Zsh(const std::vector<CommandRow>& commands) {
  std::string text =
      "#compdef fourpost\n"
      "_fourpost() {\n"
      "  if (( CURRENT == 2 )); then\n"
      "    local -a commands=(\n";
  for (const CommandRow& command : commands)
    text += "      " + Quoted(command.name + ":" + command.help, "'\\''") + "\n";
  text +=
      "    )\n"
      "    _describe command commands\n"
      "    return\n"
      "  fi\n"
      "  shift words\n"
      "  (( CURRENT-- ))\n"
      "  case $words[1] in\n";
  for (const CommandRow& command : commands) {
    text += "    " + command.name + ")\n      _arguments \\\n";
    for (const OptionRow& option : command.options) text += ZshOption(option);
    text += "        ;;\n";
  }
  return text +
         "  esac\n"
         "}\n"
         "_fourpost \"$@\"\n";
}

std::string FishOption(const CommandRow& command, const OptionRow& option) {
  std::string text = "complete -c fourpost -n '__fish_seen_subcommand_from " + command.name + "'";
  if (option.is_argument) {
    if (option.words.empty()) return "";
    return text + " -f -a " + Quoted(Joined(option.words, " "), "\\'") + "\n";
  }
  text += " -l " + option.name.substr(2);
  if (!option.short_name.empty()) text += " -s " + option.short_name.substr(1);
  if (option.takes_value) text += option.words.empty() ? " -r" : " -x -a " + Quoted(Joined(option.words, " "), "\\'");
  return text + " -d " + Quoted(option.help, "\\'") + "\n";
}

std::string Fish(const std::vector<CommandRow>& commands) {
  std::string text = "# fish completion of fourpost\n";
  for (const CommandRow& command : commands) {
    text += "complete -c fourpost -n __fish_use_subcommand -f -a " + command.name + " -d " +
            Quoted(command.help, "\\'") + "\n";
    for (const OptionRow& option : command.options) text += FishOption(command, option);
  }
  return text;
}

}  // namespace

std::string CompletionScript(const std::vector<CommandRow>& commands, std::string_view shell) {
  if (shell == "bash") return Bash(commands);
  return shell == "zsh" ? Zsh(commands) : Fish(commands);
}

}  // namespace fourpost
