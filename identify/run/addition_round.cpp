#include "identify/run/addition_round.h"

#include <algorithm>
#include <compare>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "identify/run/growth_judgement.h"
#include "identify/run/run_suggestions.h"
#include "identify/suggest/score_test.h"

namespace fourpost {
namespace {

/// Of one mechanism at several elements the others fail where the best two do: others have their turn.
constexpr std::size_t kMostTries = 4;
constexpr int kMostOfMechanism = 2;

}  // namespace

std::vector<std::size_t> WorthTrying(const Suggestions& suggestions, const GrowthRound& round,
                                     const std::vector<std::string>& taken_back) {
  struct Ranked {
    double worth = 0;
    double change = 0;
    std::size_t place = 0;
    auto operator<=>(const Ranked&) const = default;
  };
  std::vector<Ranked> found;
  for (std::size_t k = 0; k < suggestions.list.size(); ++k) {
    const SuggestedAddition& one = suggestions.list[k];
    const double change = CriterionChange(suggestions.cost, one.cost, round.residuals, one.effective,
                                          one.addition.count, round.tried, one.addition.choices);
    if (change < 0 && std::find(taken_back.begin(), taken_back.end(), one.addition.words) == taken_back.end())
      found.push_back({one.worth, change, k});
  }
  std::sort(found.begin(), found.end());
  std::map<std::string, int> of_mechanism;
  std::vector<std::size_t> places;
  for (const Ranked& one : found) {
    if (places.size() >= kMostTries) break;
    if (++of_mechanism[suggestions.list[one.place].addition.mechanism] <= kMostOfMechanism) places.push_back(one.place);
  }
  return places;
}

std::optional<GrowthRound> FindAdditions(const GrowthOrigin& origin, const GrowthPath& path, const WorkHooks& hooks) {
  const GrowthStep& before = path.steps[path.LastKept()];
  const RunSuggestions run = SuggestForRun({.run = origin.RunOf(before),
                                            .study = origin.StudyOf(before),
                                            .set = origin.SetOf(before),
                                            .threads = origin.threads},
                                           hooks);
  const Suggestions& suggestions = run.suggestions;
  if (suggestions.is_interrupted) return std::nullopt;
  GrowthRound round{.residuals = HasValidation(before) ? 0 : suggestions.residuals,
                    .tried = suggestions.tried,
                    .first = path.steps.size()};
  for (const std::size_t k : WorthTrying(suggestions, round, path.TakenBack())) {
    const SuggestedAddition& one = suggestions.list[k];
    round.candidates.push_back({.addition = {.words = one.addition.words,
                                             .mechanism = one.addition.mechanism,
                                             .elements = one.addition.elements,
                                             .variant = one.addition.variant,
                                             .amount = one.amount,
                                             .count = one.addition.count,
                                             .choices = one.addition.choices,
                                             .parameters = one.addition.parameters},
                                .folder = GrowthFolder(path.steps.size() + round.candidates.size()),
                                .effective = one.effective});
    WriteApplied(run, k + 1, origin.output / round.candidates.back().folder);
  }
  return round;
}

}  // namespace fourpost
