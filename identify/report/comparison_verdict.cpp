#include "identify/report/comparison_verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/report/fitted_data.h"

namespace fourpost {
namespace {

constexpr double kNoError = std::numeric_limits<double>::quiet_NaN();
/// GroupErrors this close are one.
constexpr double kSame = 1e-2;

using Json = nlohmann::json;
using GroupErrors = std::map<ChannelGroup, double> ComparedRun::*;

double MeanOver(const std::vector<ChannelGroup>& groups, const std::map<ChannelGroup, double>& errors) {
  double sum = 0;
  for (const ChannelGroup& group : groups) sum += errors.at(group);
  return groups.empty() ? kNoError : sum / static_cast<double>(groups.size());
}

std::string Name(const ComparedRun& run) { return html::Element("strong", "", html::Escaped(run.name)); }

/// What errors are means over.
struct Noun {
  std::string one;
  std::string several;
};

const Noun kChannels = {"group of channels", "groups of channels"};

/// "X fits best: 0.9 % ..., next Y with 1.2 %".
std::string Best(const std::vector<ComparedRun>& runs, const std::vector<ChannelGroup>& groups, GroupErrors errors,
                 const std::string& verb, const Noun& noun) {
  std::vector<std::pair<double, const ComparedRun*>> order;
  for (const ComparedRun& run : runs) order.emplace_back(MeanOver(groups, run.*errors), &run);
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto& [least, best] = order[0];
  const std::string over =
      " % mean NMSE over the " +
      (groups.size() == 1 ? "one " + noun.one : std::to_string(groups.size()) + ' ' + noun.several) +
      " that all runs have";
  if (order[1].first <= least * (1 + kSame))
    return Name(*best) + " and " + Name(*order[1].second) + ' ' + verb + " alike: " + ShownNumber(least, 3) + over +
           ". ";
  return Name(*best) + ' ' + verb + "s best: " + ShownNumber(least, 3) + over + ", next " +
         html::Escaped(order[1].second->name) + " with " + ShownNumber(order[1].first, 3) + " %. ";
}

/// By the rules of `fourpost rank`, of what all runs predicted.
ModelRanking RankByPrediction(const std::vector<ComparedRun>& runs, const std::vector<ChannelGroup>& groups) {
  std::vector<FittedModel> models;
  for (const ComparedRun& run : runs)
    models.push_back({.name = run.name,
                      .fitted_percent = kNoError,
                      .validation_percent = MeanOver(groups, run.predicted),
                      .criteria = {.parameters = run.parameters.size(), .aicc = kNoError, .bic = kNoError},
                      .termination = TextAt(run.result, "termination"),
                      .explains = ListAt(run.result.value("verdict", Json()), "reasons").empty()});
  return Rank(std::move(models));
}

std::string Text(const ModelRanking& ranking) {
  std::string text = "Recommended: " + html::Escaped(ranking.reason) + ". ";
  for (const Diagnostic& warning : ranking.warnings.items()) text += html::Escaped(warning.message) + ". ";
  return text;
}

/// Recordings, their bytes, and the band.
bool SawTheSame(const ComparedRun& a, const ComparedRun& b) {
  return a.Recordings() == b.Recordings() && FittedDigests(a.result) == FittedDigests(b.result) &&
         a.result.value("band_Hz", Json()) == b.result.value("band_Hz", Json());
}

/// Of runs that saw the same by groups of channels, of others by recordings that all of them saw over one band.
std::optional<std::string> WhichFitsBest(const std::vector<ComparedRun>& runs) {
  const bool is_same =
      std::all_of(runs.begin(), runs.end(), [&](const ComparedRun& run) { return SawTheSame(run, runs.front()); });
  const std::vector<ChannelGroup> groups = CommonGroups(runs, &ComparedRun::fitted);
  if (is_same && !groups.empty()) return Best(runs, groups, &ComparedRun::fitted, "fit", kChannels);
  const std::vector<ChannelGroup> recordings = CommonGroups(runs, &ComparedRun::recordings);
  if (recordings.empty()) return std::nullopt;
  return Best(runs, recordings, &ComparedRun::recordings, "fit", {"recording", "recordings"});
}

/// What the runs do not share.
std::string Doubts(const std::vector<ComparedRun>& runs) {
  std::string text;
  if (std::any_of(runs.begin(), runs.end(), [](const ComparedRun& run) { return run.data != 0; }))
    text +=
        "The runs were not all fitted to the same data with the same weights, as far as their folders show: each error "
        "is that of the run's own recordings, and costs compare within a letter only. ";
  return text;
}

/// Difference over the deviation of the difference; 0 where an interval is missing or both overlap.
double SdApart(const ReportedParameter& one, const ReportedParameter& other) {
  if (!std::isfinite(one.sd) || !std::isfinite(other.sd)) return 0;
  if (one.lower_95 <= other.upper_95 && other.lower_95 <= one.upper_95) return 0;
  return std::abs(one.value - other.value) / std::hypot(one.sd, other.sd);
}

/// "k_front (A 54.3 kN/m, B 48.1 kN/m: 3.2 standard deviations), ..." of two runs, the worst first.
std::string ContradictionsOf(const ComparedRun& a, const ComparedRun& b) {
  std::vector<std::pair<double, std::string>> found;
  for (const ReportedParameter& one : a.parameters)
    for (const ReportedParameter& other : b.parameters) {
      if (one.name != other.name || one.unit != other.unit) continue;
      const double by = SdApart(one, other);
      if (by == 0) continue;
      found.emplace_back(by, html::Escaped(one.name) + " (" + ShownNumber(one.value, 3) + " and " +
                                 ShownNumber(other.value, 3) + ' ' + html::Escaped(one.unit) + ", " +
                                 ShownNumber(by, 2) + " standard deviations)");
    }
  std::stable_sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  std::string text;
  for (const auto& [by, words] : found) text += (text.empty() ? "" : ", ") + words;
  return text;
}

/// Parameters on which two runs disagree by more than both say they could be wrong.
std::string Contradictions(const std::vector<ComparedRun>& runs) {
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t k = i + 1; k < runs.size(); ++k)
      if (const std::string found = ContradictionsOf(runs[i], runs[k]); !found.empty())
        text += Name(runs[i]) + " and " + Name(runs[k]) +
                " contradict each other, their intervals do not meet: " + found + ". ";
  if (text.empty()) return "";
  return text + "Data or models differ in what these parameters stand for: at least one model lacks something.";
}

}  // namespace

std::string VerdictHtml(const std::vector<ComparedRun>& runs, const std::optional<ModelRanking>& ranking) {
  if (runs.size() < 2) return "";
  const std::vector<ChannelGroup> predicted = CommonGroups(runs, &ComparedRun::predicted);
  const std::optional<std::string> fits = WhichFitsBest(runs);
  std::string text =
      fits.value_or("No recording was fitted by all runs over one band, so the runs cannot be ranked by fit. ");
  if (predicted.empty()) text += "No common validation recording, so the runs cannot be ranked by prediction. ";
  else text += Best(runs, predicted, &ComparedRun::predicted, "predict", kChannels);
  if (ranking) text += Text(*ranking);
  else if (!predicted.empty()) text += Text(RankByPrediction(runs, predicted));
  const bool tells = ranking || fits || !predicted.empty();
  const std::string doubts = Doubts(runs);
  const std::string contradictions = Contradictions(runs);
  return html::Element("p", tells ? "verdict good" : "verdict open", text) + '\n' +
         (doubts.empty() ? "" : html::Element("p", "note", doubts) + '\n') +
         (contradictions.empty() ? "" : html::Element("p", "note", contradictions) + '\n');
}

}  // namespace fourpost
