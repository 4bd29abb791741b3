#include "identify/run/fit_verdict.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/text/short_number.h"

namespace fourpost {
namespace {

/// Of the loudest of its unit, as root mean squares. Next to a node small errors are large shares.
constexpr double kLoudOverFrequency = 0.1;
/// What an accelerometer takes of a motion across its axis is less.
constexpr double kLoudOverTime = 0.02;

/// Squares of errors over squares measured, of one channel or of one recording in one unit.
struct Group {
  std::string words;
  std::string kind;
  double loud = 0;
  double error = 0;
  double measured = 0;
};

void AddTo(std::vector<Group>& groups, const std::string& words, const ErrorShare& share) {
  auto found = std::find_if(groups.begin(), groups.end(),
                            [&](const Group& group) { return group.words == words && group.kind == share.kind; });
  if (found == groups.end())
    found = groups.insert(
        groups.end(),
        {.words = words, .kind = share.kind, .loud = share.has_nodes ? kLoudOverFrequency : kLoudOverTime});
  found->error += share.error;
  found->measured += share.measured;
}

/// "channel 's_front' has an NMSE of 240 %, more than a constant would", of the groups that are loud enough.
void AddPoor(const std::vector<Group>& groups, std::vector<std::string>& reasons) {
  std::map<std::string, double> loudest;
  for (const Group& group : groups) loudest[group.kind] = std::max(loudest[group.kind], group.measured);
  for (const Group& group : groups) {
    const bool is_loud = group.measured > 0 && group.measured >= group.loud * group.loud * loudest[group.kind];
    if (is_loud && group.error > group.measured)
      reasons.push_back(group.words + " has an NMSE of " + ShortNumber(100 * group.error / group.measured, 3) +
                        " %, more than if nothing were modelled (100 %)");
  }
}

void AddBounds(const FitResult& fit, std::vector<std::string>& reasons) {
  constexpr double kExplained = 1.5;
  const auto at_bound = std::count_if(fit.parameters.begin(), fit.parameters.end(),
                                      [](const FittedParameter& parameter) { return parameter.at_bound; });
  if (2 * at_bound <= std::ssize(fit.parameters) || fit.Misfit() <= kExplained) return;
  reasons.push_back(std::to_string(at_bound) + " of " + std::to_string(fit.parameters.size()) +
                    " parameters are at their bounds");
}

}  // namespace

FitVerdict JudgeFit(const FitResult& fit, const std::vector<ErrorShare>& shares) {
  if (fit.end == FitEnd::kInterrupted) return {};
  std::vector<Group> channels;
  std::vector<Group> recordings;
  for (const ErrorShare& share : shares) {
    AddTo(channels, "channel '" + share.channel + "'", share);
    AddTo(recordings, "recording '" + share.recording + "' in " + share.unit, share);
  }
  FitVerdict verdict;
  AddPoor(channels, verdict.reasons);
  AddPoor(recordings, verdict.reasons);
  AddBounds(fit, verdict.reasons);
  return verdict;
}

std::string VerdictText(const FitVerdict& verdict) {
  std::string text;
  for (const std::string& reason : verdict.reasons) text += (text.empty() ? "" : "; ") + reason;
  return text.empty() ? "" : "this model does not explain these data: " + text;
}

}  // namespace fourpost
