#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/work_progress.h"
#include "identify/suggest/suggestion_json.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

std::string MovedText(const SuggestedAddition& suggestion) {
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t i = 0; i < suggestion.moved.size() && i < kMost; ++i)
    text += (text.empty() ? "" : ", ") + suggestion.moved[i].name + (suggestion.moved[i].share > 0 ? " +" : " ") +
            Rounded(100 * suggestion.moved[i].share, 2) + " %";
  return text;
}

std::string AlikeText(const Suggestions& suggestions) {
  std::string text;
  for (std::size_t i = 0; i < suggestions.list.size(); ++i) {
    std::string others;
    for (const std::size_t k : suggestions.list[i].like)
      if (k > i) others += (others.empty() ? "" : ", ") + std::to_string(k + 1);
    if (!others.empty()) text += "These data cannot distinguish " + std::to_string(i + 1) + " from " + others + ".\n";
  }
  return text;
}

/// By their reasons, those of most additions first.
std::string UntestedText(const std::vector<UntestedAddition>& failed) {
  std::map<std::string, std::vector<std::string>> by_reason;
  for (const UntestedAddition& one : failed) by_reason[one.reason].push_back(one.words);
  std::vector<std::pair<std::string, std::vector<std::string>>> reasons(by_reason.begin(), by_reason.end());
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
  std::string text;
  for (const auto& [reason, words] : reasons)
    text += "  " + std::to_string(words.size()) + ", such as " + words.front() + ": " + reason + '\n';
  return text.empty() ? "" : "Additions that cannot be evaluated:\n" + text;
}

std::string Text(const SuggestCommand& command, const RunSuggestions& run) {
  const Suggestions& all = run.suggestions;
  const std::size_t worthwhile = all.Worthwhile();
  const std::size_t shown = command.all ? all.list.size() : worthwhile;
  std::string text;
  if (shown > 0) {
    TextTable table({"no.", "add", "expected", "cost falls, %", "change of BIC", "moves"});
    for (std::size_t i = 0; i < shown; ++i) {
      const SuggestedAddition& one = all.list[i];
      table.Add({std::to_string(i + 1), one.addition.words, ExpectedText(one, run.study), Rounded(100 * one.fall, 3),
                 Rounded(one.criterion, 3), MovedText(one)});
    }
    text = table.Format() + '\n' + AlikeText(all);
  }
  if (worthwhile == 0) text += "No addition that was tried lowers BIC.\n";
  text += "Misfit " + (std::isnan(run.misfit) ? "not known" : Rounded(run.misfit, 3)) + "; " +
          std::to_string(all.residuals) + " residuals worth " + Rounded(all.effective, 3) + " independent ones; " +
          std::to_string(all.tried) + " additions tried, " + std::to_string(all.failed.size()) +
          " of them cannot be evaluated; " + std::to_string(all.evaluations) + " evaluations\n";
  return text + UntestedText(all.failed);
}

std::string AsJson(const SuggestCommand& command, const RunSuggestions& run) {
  const Suggestions& all = run.suggestions;
  const std::size_t shown = command.all ? all.list.size() : all.Worthwhile();
  Json list = Json::array();
  for (std::size_t i = 0; i < shown; ++i) list.push_back(SuggestionJson(all.list[i], i + 1, run.study));
  Json failures = Json::array();
  for (const UntestedAddition& one : all.failed) failures.push_back({{"text", one.words}, {"reason", one.reason}});
  return JsonText(Json{{"run", command.run.filename().string()},
                       {"cost", all.cost},
                       {"misfit", NumberOrNull(run.misfit)},
                       {"residuals", all.residuals},
                       {"effective_residuals", all.effective},
                       {"tried", all.tried},
                       {"failed", all.failed.size()},
                       {"failures", failures},
                       {"evaluations", all.evaluations},
                       {"suggestions", list}});
}

}  // namespace

int Run(const SuggestCommand& command) {
  RequireFitResult(command.run);
  CatchInterrupts();
  WorkProgress progress;
  const RunSuggestions run = SuggestForRun(command, progress.Hooks());
  if (run.suggestions.is_interrupted) return kInterrupted;
  progress.End();
  if (command.apply > 0) WriteApplied(run, command.apply, command.output);
  if (command.json) Print(AsJson(command, run));
  else PrintText(Text(command, run));
  if (command.apply > 0)
    std::fprintf(stderr, "suggestion %zu: %s; fit it with `fourpost fit %s -o FOLDER`\n", command.apply,
                 command.output.c_str(), (command.output / "study.yaml").c_str());
  return kGood;
}

}  // namespace fourpost
