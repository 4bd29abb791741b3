#include "identify/run/fit_verdict.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/text/short_number.h"
#include "identify/run/findings.h"
#include "identify/run/fit_text.h"
#include "identify/uncertainty/findings.h"
#include "identify/uncertainty/other_optima.h"

namespace fourpost {
namespace {

/// Of the loudest of its unit, as root mean squares. Next to a node small errors are large shares.
constexpr double kLoudOverFrequency = 0.1;
/// What an accelerometer takes of a motion across its axis is less.
constexpr double kLoudOverTime = 0.02;

/// Normalised mean square errors below which model and measurement look alike, and above which they do not, as reports
/// judge histories.
constexpr double kFollowedShare = 0.05;
constexpr double kPoorShare = 0.2;

/// Squares of errors over squares measured, of one channel or of one recording in one unit.
struct Group {
  /// Of the finding where it is poor, but for the error.
  std::vector<std::string> words;
  std::string kind;
  double loud = 0;
  double error = 0;
  double measured = 0;
};

void AddTo(std::vector<Group>& groups, const std::vector<std::string>& words, const ErrorShare& share) {
  auto found = std::find_if(groups.begin(), groups.end(),
                            [&](const Group& group) { return group.words == words && group.kind == share.kind; });
  if (found == groups.end())
    found = groups.insert(
        groups.end(),
        {.words = words, .kind = share.kind, .loud = share.has_nodes ? kLoudOverFrequency : kLoudOverTime});
  found->error += share.error;
  found->measured += share.measured;
}

/// Groups that are loud enough to judge, by their places.
std::vector<const Group*> Loud(const std::vector<Group>& groups) {
  std::map<std::string, double> loudest;
  for (const Group& group : groups) loudest[group.kind] = std::max(loudest[group.kind], group.measured);
  std::vector<const Group*> loud;
  for (const Group& group : groups)
    if (group.measured > 0 && group.measured >= group.loud * group.loud * loudest[group.kind]) loud.push_back(&group);
  return loud;
}

/// For which a constant would do better.
void AddUnexplained(const std::vector<Group>& groups, const Finding& kind, Diagnostics& reasons) {
  for (const Group* const group : Loud(groups)) {
    if (group->error <= group->measured) continue;
    std::vector<std::string> words = group->words;
    words.push_back(ShortNumber(100 * group->error / group->measured, 3));
    reasons.Report(kind, {}, words);
  }
}

/// Channels whose error is above this share of what was measured.
std::ptrdiff_t CountAbove(double share, const std::vector<const Group*>& channels) {
  return std::count_if(channels.begin(), channels.end(),
                       [&](const Group* channel) { return channel->error > share * channel->measured; });
}

void AddPoor(const FitResult& fit, const std::vector<const Group*>& channels, Diagnostics& reasons) {
  const std::ptrdiff_t poor = CountAbove(kPoorShare, channels);
  if (2 * poor <= std::ssize(channels) || !(fit.Misfit() > kLargeMisfit)) return;
  reasons.Report(kMostChannelsPoor, {},
                 {std::to_string(poor), std::to_string(channels.size()), ShortNumber(100 * kPoorShare, 2),
                  ShortNumber(fit.Misfit(), 2)});
}

/// A few parameters at their bounds are usual, such as friction where there is none, and so are many where the channels
/// are followed all the same.
void AddBounds(const FitResult& fit, const std::vector<const Group*>& channels, Diagnostics& reasons) {
  const auto at_bound = std::count_if(fit.parameters.begin(), fit.parameters.end(),
                                      [](const FittedParameter& parameter) { return parameter.at_bound; });
  const auto count = std::ssize(fit.parameters);
  const bool are_most = 2 * at_bound > count && fit.Misfit() > kLargeMisfit;
  const bool are_many = 4 * at_bound > count && fit.Misfit() > kFarMisfit &&
                        2 * CountAbove(kFollowedShare, channels) > std::ssize(channels);
  if (are_most || are_many)
    reasons.Report(kParametersAtBounds, {},
                   {std::to_string(at_bound), std::to_string(count), ShortNumber(fit.Misfit(), 2)});
}

/// Parameters and directions without standard deviation.
void AddOpen(const FitResult& fit, Diagnostics& conclusions) {
  std::string noisy;
  for (const FittedParameter& parameter : fit.parameters)
    if (parameter.state == ParameterState::kNoise) noisy += (noisy.empty() ? "" : ", ") + parameter.name;
  if (!noisy.empty()) conclusions.Report(kDerivativeNoise, {}, {noisy});
  const Covariance& covariance = *fit.covariance;
  if (covariance.rank >= covariance.directions.cols()) return;
  if (covariance.directions.cols() == 1) return conclusions.Report(kParameterUndetermined, {});
  for (const std::string& combination : fit.weakest) {
    const bool is_one = combination.find(',') == std::string::npos;
    const std::string name = combination.substr(0, combination.find(' '));
    if (is_one) conclusions.Report(kWithoutEffect, {}, {name});
    else conclusions.Report(kDirectionUndetermined, {}, {combination});
  }
}

/// Parameters that only their bounds limit, though they have a deviation.
void AddLimitedByBounds(const FitResult& fit, Diagnostics& conclusions) {
  constexpr std::string_view kHeld = "held: ";
  std::string names;
  std::string of_held;
  for (const FittedParameter& one : fit.parameters) {
    if (one.state != ParameterState::kUndetermined || !FillsBounds(one.lower_95, one.upper_95, one.lower, one.upper))
      continue;
    if (one.limited_by.starts_with(kHeld))
      of_held += (of_held.empty() ? "" : ", ") + one.name + " (" + one.limited_by.substr(kHeld.size()) + ")";
    else names += (names.empty() ? "" : ", ") + one.name;
  }
  if (!names.empty()) conclusions.Report(kIntervalFillsBounds, {}, {names});
  if (!of_held.empty()) conclusions.Report(kHeldFillsBounds, {}, {of_held});
}

/// Where the data would take it further: zero is often the end of what is physical.
void AddAtBounds(const FitResult& fit, Diagnostics& conclusions) {
  std::string names;
  for (const FittedParameter& one : fit.parameters) {
    const bool is_lower = one.BoundName() == "lower";
    if (one.state == ParameterState::kUndetermined) continue;
    if (one.at_bound && (is_lower ? one.lower : one.upper) != 0)
      names += (names.empty() ? "" : ", ") + one.name + (is_lower ? " (lower)" : " (upper)");
  }
  if (!names.empty()) conclusions.Report(kEndedAtBounds, {}, {names});
}

/// By chance in one of 16,000 parameters.
void AddFarFromPrior(const FitResult& fit, Diagnostics& conclusions) {
  constexpr double kFar = 4;
  std::string names;
  for (const FittedParameter& one : fit.parameters)
    if (std::abs(one.FromPrior()) > kFar)
      names +=
          (names.empty() ? "" : ", ") + one.name + " by " + ShortNumber(one.FromPrior(), 2) + " standard deviations";
  if (!names.empty()) conclusions.Report(kFarFromPrior, {}, {names});
}

/// A best point that no other refinement found.
void AddDisagreement(const FitResult& fit, Diagnostics& conclusions) {
  constexpr int kEnough = 3;
  if (fit.end == FitEnd::kInterrupted || fit.starts < kEnough || fit.agreeing >= 2) return;
  conclusions.Report(kRefinementsDisagree, {}, {std::to_string(fit.agreeing), std::to_string(fit.starts)});
}

void AddHeld(const FitResult& fit, Diagnostics& conclusions) {
  if (!fit.certainty) return;
  std::string names;
  for (const std::string& name : fit.certainty->held_left_out) names += (names.empty() ? "" : ", ") + name;
  if (!names.empty()) conclusions.Report(kHeldLeftOut, {}, {names});
}

/// Optima that noise and model error do not distinguish from the best. Costs before a correction are those of another
/// model.
void AddOtherOptima(const FitResult& fit, Diagnostics& conclusions) {
  const std::optional<ParameterSpread> spread = fit.Spread();
  if (!spread) return;
  std::vector<EndedStart> ends;
  for (const RefinedStart& run : fit.refined) {
    if (run.from == "fit") return;
    if (run.end != RefineEnd::kConverged || run.agrees || run.values.size() != fit.parameters.size()) continue;
    ends.push_back({run.cost, Eigen::Map<const Eigen::VectorXd>(run.values.data(), spread->values.size())});
  }
  const std::vector<EndedStart> others =
      OtherOptima(ends, *spread, fit.cost, fit.covariance->inflation, spread->AboutMoved());
  std::string costs;
  for (const EndedStart& other : others) costs += (costs.empty() ? "" : ", ") + ShortNumber(other.cost, 6);
  if (!others.empty())
    conclusions.Report(kOtherOptima, {},
                       {others.size() == 1 ? "another optimum" : std::to_string(others.size()) + " other optima", costs,
                        ShortNumber(fit.cost, 6)});
}

void AddCalibrations(const FitResult& fit, Diagnostics& conclusions) {
  if (!fit.certainty) return;
  std::string beyond;
  for (const CalibrationEstimate& one : fit.certainty->calibrations)
    if (IsSurprising(one))
      beyond += (beyond.empty() ? "" : ", ") + one.name + " " + InstrumentNumber(one.estimate, one.unit) + " (stated " +
                InstrumentNumber(one.sd, one.unit) + ")";
  if (!beyond.empty()) conclusions.Report(kCalibrationBeyond, {}, {beyond});
}

std::string Joined(const Diagnostics& reasons) {
  std::string text;
  for (const Diagnostic& reason : reasons.items()) text += (text.empty() ? "" : "; ") + reason.message;
  return text;
}

}  // namespace

FitVerdict JudgeFit(const FitResult& fit, const std::vector<ErrorShare>& shares, const Diagnostics& accepted) {
  if (fit.end == FitEnd::kInterrupted) return {};
  std::vector<Group> channels;
  std::vector<Group> recordings;
  for (const ErrorShare& share : shares) {
    AddTo(channels, {share.channel}, share);
    AddTo(recordings, {share.recording, share.unit}, share);
  }
  FitVerdict verdict{.reasons = {}, .accepted = accepted};
  AddUnexplained(channels, kChannelUnexplained, verdict.reasons);
  AddUnexplained(recordings, kRecordingUnexplained, verdict.reasons);
  AddPoor(fit, Loud(channels), verdict.reasons);
  AddBounds(fit, Loud(channels), verdict.reasons);
  if (!accepted.items().empty() && fit.Misfit() > kLargeMisfit)
    verdict.reasons.Report(kImplausibleUnexplained, {}, {ShortNumber(fit.Misfit(), 2)});
  return verdict;
}

Diagnostics ConclusionsOf(const FitResult& fit, const FitVerdict& verdict, bool has_deviations) {
  Diagnostics conclusions;
  if (fit.end == FitEnd::kNotConverged) conclusions.Report(kFitNotConverged, {}, {fit.message});
  AddDisagreement(fit, conclusions);
  if (!has_deviations) conclusions.Report(kCompromiseWithoutDeviations, {});
  else if (fit.covariance) AddOpen(fit, conclusions);
  else conclusions.Report(kEndedWithoutDeviations, {});
  if (has_deviations && fit.is_input_noise_implausible) conclusions.Report(kPostNoiseImplausible, {});
  if (has_deviations && fit.are_calibrations_unused) conclusions.Report(kCalibrationUnused, {});
  if (has_deviations) {
    AddOtherOptima(fit, conclusions);
    AddAtBounds(fit, conclusions);
    AddFarFromPrior(fit, conclusions);
    AddLimitedByBounds(fit, conclusions);
    AddCalibrations(fit, conclusions);
    AddHeld(fit, conclusions);
  }
  if (!verdict.accepted.items().empty()) conclusions.Report(kImplausibleAccepted, {}, {Joined(verdict.accepted)});
  if (!verdict.explains()) conclusions.Report(kModelUnexplaining, {}, {Joined(verdict.reasons)});
  return conclusions;
}

}  // namespace fourpost
