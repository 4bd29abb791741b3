#include "identify/report/report_summary.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "analysis/text/counted.h"
#include "analysis/text/enumeration.h"
#include "identify/report/channel_list.h"
#include "identify/report/grown_path.h"
#include "identify/report/missing_additions.h"
#include "identify/report/modelled_recordings.h"
#include "identify/report/report_tiles.h"
#include "identify/report/sentences_html.h"
#include "identify/uncertainty/derivative_noise.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

// Relative standard deviations.
constexpr double kWellKnown = 0.02;
constexpr double kWeaklyKnown = 0.1;
// Correlations.
constexpr double kTied = 0.95;

using html::Code;

std::vector<std::string> AsCode(const std::vector<std::string>& names) {
  std::vector<std::string> codes;
  for (const std::string& name : names) codes.push_back(Code(name));
  return codes;
}

std::size_t CountOf(const std::vector<JudgedChannel>& channels, Follows follows) {
  return static_cast<std::size_t>(std::count_if(
      channels.begin(), channels.end(), [&](const JudgedChannel& channel) { return channel.follows == follows; }));
}

/// {"id", "text"}, or the text alone of an older run.
std::string FindingText(const Json& finding) {
  if (finding.is_string()) return finding.get<std::string>();
  return finding.is_object() ? TextAt(finding, "text") : "";
}

/// Empty for a run that explains its data, or does not say.
std::string DoesNotExplain(const Json& result) {
  const std::vector<Json> reasons = ListAt(result.value("verdict", Json()), "reasons");
  std::vector<std::string> listed;
  for (const Json& reason : reasons)
    if (const std::string text = FindingText(reason); !text.empty()) listed.push_back(CodeHtml(text));
  if (listed.empty()) return "";
  return "<strong>The model does not explain the data:</strong> " + Enumeration(listed) + ". ";
}

/// What the check of the recordings would have refused; empty where nothing was accepted.
std::string WhatWasAccepted(const Json& result) {
  std::vector<std::string> listed;
  for (const Json& one : ListAt(result.value("verdict", Json()), "accepted"))
    if (const std::string text = FindingText(one); !text.empty()) listed.push_back(CodeHtml(text));
  return listed.empty() ? "" : "<strong>Implausible values were accepted:</strong> " + Enumeration(listed) + ". ";
}

/// Of a run that was cut short what it had done by then.
std::string Agreement(const Json& result, bool is_cut_short) {
  const Json starts = result.value("starts", Json());
  const double refined = NumberAt(starts, "refined");
  const double agreeing = NumberAt(starts, "agreeing");
  const double paid = NumberAt(result.value("evaluations", Json()), "paid");
  std::string text;
  if (is_cut_short && std::isfinite(paid)) text = "It was stopped after " + ShownDecimals(paid, 0) + " evaluations";
  if (!(refined > 0)) return text.empty() ? "" : text + ", before any refinement had ended. ";
  if (!text.empty()) text += ". ";
  if (refined == 1) return text + "Only one refinement ended, so agreement cannot be checked. ";
  return text + ShownDecimals(agreeing, 0) + " of " + ShownDecimals(refined, 0) + " refinements" +
         (is_cut_short ? " that had ended" : "") + ", each from its own start, reached the same optimum" +
         (agreeing < refined ? "; the others ended higher. " : ". ");
}

/// Said of a run that another version made.
std::string OfAnotherVersion(const Json& result) {
  const std::string version = TextAt(result.value("versions", Json()), "fourpost");
  const std::string own = Versions().front().second;
  if (version.empty() || version == own) return "";
  return "The run was made by fourpost " + html::Escaped(version) + ", this page by " + own +
         ", which leaves out what it does not know.";
}

std::string HowItEnded(const std::string& end) {
  if (end == "converged") return "<strong>The fit converged.</strong> ";
  if (end == "interrupted")
    return "<strong>The fit is not finished, it was interrupted.</strong> This is the best point until then. ";
  if (end == "all_failed") return "<strong>Every simulation failed.</strong> Nothing was fitted. ";
  if (end == "not_converged") return "<strong>The fit did not converge.</strong> A better point may be near. ";
  return "<strong>The end of the fit is of an unknown kind.</strong> ";
}

/// What the fit is worth, in the words of its overview.
std::string VerdictHtml(const Json& result, const FitOverview& overview) {
  const std::string end = TextAt(result, "termination");
  const std::string against = DoesNotExplain(result);
  std::string text = InterruptedGrowth(result) + (against.empty() ? HowItEnded(end) : against) +
                     WhatWasAccepted(result) + Agreement(result, end == "interrupted");
  for (const std::string& sentence :
       {ResidualSentence(overview), WorstSentence(overview), DisagreementSentence(overview)})
    if (!sentence.empty()) text += CodeHtml(sentence) + ' ';
  if (!overview.IsExplained())
    if (const std::string missing = MostLikelyMissing(result); !missing.empty()) text += missing + ' ';
  return text + OfAnotherVersion(result);
}

std::string Item(const std::string& title, const std::string& html) {
  return html.empty() ? "" : "<dt>" + title + "</dt><dd>" + html + "</dd>\n";
}

std::string WhatFits(const std::vector<JudgedChannel>& channels) {
  if (channels.empty()) return "";
  const std::size_t well = CountOf(channels, Follows::kWell);
  const std::string within = "within " + ShownLimits(channels);
  if (well == 0) return "No channel is " + within + ".";
  return ChannelList(channels, Follows::kWell, false) + (well == 1 ? " is " : " are ") + within + ".";
}

std::string WhatDoesNot(const std::vector<JudgedChannel>& channels) {
  const std::string roughly = ChannelList(channels, Follows::kRoughly, true);
  const std::string far = ChannelList(channels, Follows::kNot, true);
  std::string text;
  if (!far.empty()) text += "Poor: " + far + ". ";
  if (!roughly.empty()) text += "Fair: " + roughly + ". ";
  return text;
}

std::string Sentences(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + ' ' + second;
}

/// Of recordings that were not fitted.
std::string WhatItMisses(const std::vector<JudgedChannel>& unseen) {
  const std::string far = ChannelList(unseen, Follows::kNot, true);
  return far.empty() ? "" : "Poor on recordings that were not fitted: " + far + ". ";
}

/// What channels of recordings that were not fitted are counted as: a damper has one in each, a vehicle many.
std::string Unseen(const std::vector<Json>& validation) {
  std::set<std::string> names;
  std::set<std::string> recordings;
  for (const Json& channel : validation) {
    names.insert(TextAt(channel, "name"));
    recordings.insert(TextAt(channel, "recording"));
  }
  if (names.size() == 1) return "recordings";
  return recordings.size() == 1 ? "channels of " + Code(*recordings.begin())
                                : "channels of " + std::to_string(recordings.size()) + " recordings";
}

/// Of recordings that were not fitted.
std::string WhatItPredicts(const std::vector<Json>& validation, const std::vector<JudgedChannel>& channels) {
  if (channels.empty()) return "";
  return std::to_string(CountOf(channels, Follows::kWell)) + " of " + std::to_string(channels.size()) + ' ' +
         Unseen(validation) + " that were not fitted are within " + ShownLimits(channels) + "; the worst is " +
         Code(channels.back().name) + " (" + html::Escaped(channels.back().numbers) + ").";
}

/// Of what was kept for validation.
std::string WhatWasLeftOut(const Json& result) {
  std::string text;
  for (const Json& recording : ListAt(result, "validation_left_out"))
    text += "Left out of validation: " + Code(TextAt(recording, "recording")) + " (" +
            html::Escaped(TextAt(recording, "reason")) + "). ";
  return text;
}

std::string WhatIsDetermined(const std::vector<ReportedParameter>& parameters) {
  std::vector<std::string> weak;
  int well = 0;
  int known = 0;
  for (const ReportedParameter& parameter : parameters) {
    const double sd = parameter.RelativeSd();
    // A bound that holds a parameter knows it, not the data.
    if (!std::isfinite(sd) || parameter.at_bound || parameter.state == ParameterState::kUndetermined) continue;
    ++known;
    if (sd <= kWellKnown) ++well;
    if (sd > kWeaklyKnown) weak.push_back(Code(parameter.name) + " (" + ShownNumber(100 * sd, 2) + " %)");
  }
  const bool computed = std::any_of(parameters.begin(), parameters.end(),
                                    [](const ReportedParameter& parameter) { return std::isfinite(parameter.sd); });
  if (!computed) return "";
  const std::string limit = " within " + ShownNumber(100 * kWellKnown, 1) + " % (one standard deviation).";
  std::string text = std::to_string(known) + " of " + std::to_string(parameters.size()) +
                     " parameters are determined, " + std::to_string(well) + " of them" + limit;
  if (parameters.size() == 1 && known == 1)
    text = "The one parameter is determined" + (well == 1 ? "," + limit : std::string("."));
  if (!weak.empty()) text += " Weakly determined: " + Enumeration(weak) + ".";
  return text;
}

std::vector<std::string> AtBounds(const std::vector<ReportedParameter>& parameters) {
  std::vector<std::string> names;
  for (const ReportedParameter& parameter : parameters)
    if (parameter.at_bound) names.push_back(Code(parameter.name));
  return names;
}

std::string WhatIsNot(const Json& result, const std::vector<ReportedParameter>& parameters,
                      const ReportRemarks& remarks) {
  if (parameters.empty()) return "";
  std::vector<std::string> open;
  const std::vector<std::string> bound = AtBounds(parameters);
  if (const std::string why = WhyNoDeviations(parameters, remarks.why_no_deviations); !why.empty())
    return html::Escaped(why);
  for (const ReportedParameter& parameter : parameters)
    if (std::isinf(parameter.sd) || parameter.state == ParameterState::kUndetermined)
      open.push_back(Code(parameter.name));
  std::string text;
  if (!open.empty()) text += "Not determined by the data: " + Enumeration(open) + ". ";
  if (!bound.empty()) text += "Held by a bound, not by the data: " + Enumeration(bound) + ". ";
  if (const std::vector<std::string> noisy = NamesIn(ParameterState::kNoise, parameters); !noisy.empty())
    text += "The derivative is noise: " + Enumeration(AsCode(noisy)) + "; " + html::Escaped(kNoiseRemedy) + ". ";
  const Json identifiability = result.value("identifiability", Json());
  if (NumberAt(identifiability, "rank") < NumberAt(identifiability, "parameters"))
    for (const Json& direction : ListAt(identifiability, "weakest"))
      if (direction.is_string())
        text += "Not identifiable direction: " + html::Escaped(direction.get<std::string>()) + ". ";
  return text.empty() ? "Nothing: every parameter has a finite standard deviation and is off its bounds." : text;
}

/// Parameters that are strongly correlated; empty where there are none.
std::string Ties(const std::vector<ReportedParameter>& parameters) {
  std::vector<std::string> tied;
  double closest = 0;
  for (const ReportedParameter& parameter : parameters) {
    if (!std::isfinite(parameter.sd) || !(std::abs(parameter.correlation) > kTied)) continue;
    tied.push_back(Code(parameter.name));
    if (std::abs(parameter.correlation) > std::abs(closest)) closest = parameter.correlation;
  }
  if (tied.empty()) return "";
  return Enumeration(tied) + (tied.size() == 1 ? " is" : " are") + " strongly correlated with others (" +
         (tied.size() > 2 ? "up to " : "") + ShownDecimals(closest, 2) +
         "), so the data determine their combinations better than each. Weigh a part, or add a channel that depends on "
         "one alone, such as a force or a static load.";
}

/// No part of the data asks for other parameters than the rest, beyond noise.
bool AgreesWithItself(const Json& result) {
  const Json intervals = result.value("intervals", Json::object());
  return intervals.contains("model_error") && intervals["model_error"] == false;
}

/// Where the residuals of stepped sines are largest; empty where no place is known.
std::string AtWorstPlace(const FitOverview& overview, bool is_wiring_cleared) {
  const JudgedChannel* const channel = overview.Worst();
  if (channel == nullptr || !channel->worst) return "";
  const WorstPlace& place = *channel->worst;
  const std::string where = ShownShort(std::sqrt(place.lower_Hz * place.upper_Hz), 2) + " Hz";
  const bool is_slow = place.upper_Hz <= 2;
  return (is_wiring_cleared
              ? "The audit suspects no channel, so at " + Code(channel->name) + " the model lacks a mechanism near " +
                    where
              : "Check the wiring of " + Code(channel->name) +
                    " (sign, scale, delay, position). If it is right, the model lacks a mechanism near " + where) +
         (is_slow ? ". Large errors in small slow strokes are typical of dry friction. Add friction, or test these "
                    "frequencies at two amplitudes: friction makes the gain depend on amplitude."
                  : ". Repeat the recording at another amplitude: a nonlinear law changes with it, a missing "
                    "degree of freedom does not.");
}

/// Where residuals are larger than noise and stated model error explain.
std::string OnMisfit(const Json& result, const ReportRemarks& remarks, const FitOverview& overview) {
  if (AgreesWithItself(result))
    return "Residuals are larger than their stated standard deviations, yet no part of the data contradicts another. "
           "State the "
           "noise that the recordings have.";
  if (const std::string correction = LikeliestCorrection(result); !correction.empty())
    return "Check the wiring: " + correction +
           " explains more of the residuals than any mechanism that was tried. Correct it in the study and fit again "
           "before you add one.";
  if (const std::string place = AtWorstPlace(overview, remarks.is_wiring_cleared); !place.empty()) return place;
  return "Check sign, scale, delay and position of the channels with large residuals. If they are right, the model "
         "lacks a mechanism: fit a richer one to the same recordings and compare the runs.";
}

std::vector<std::string> WhatNext(const Json& result, const std::vector<ReportedParameter>& parameters,
                                  const ReportRemarks& remarks, const FitOverview& overview) {
  // What has not ended says little of the model.
  if (TextAt(result, "termination") == "interrupted")
    return {"Run the same command again; it continues from its archive."};
  if (TextAt(result, "termination") == "not_converged")
    return {"Run the same command again with more evaluations or iterations; it continues from its archive."};
  std::vector<std::string> advice;
  if (!InterruptedGrowth(result).empty())
    advice.push_back("Run the same command again; growth goes on where it was interrupted.");
  const Json identifiability = result.value("identifiability", Json());
  const bool open = NumberAt(identifiability, "rank") < NumberAt(identifiability, "parameters");
  if (open && !remarks.measures_force && !remarks.where_open.empty()) advice.push_back(remarks.where_open);
  else if (open)
    advice.push_back(
        "Fix one parameter of each direction that is not identifiable, give it a prior, or measure a channel that it "
        "affects.");
  if (const std::vector<std::string> bound = AtBounds(parameters); !bound.empty())
    advice.push_back("Check the bounds of " + Enumeration(bound) +
                     ". If they are guesses, widen them. If they are certain, the model lacks a mechanism that " +
                     (bound.size() == 1 ? "this parameter compensates." : "these parameters compensate."));
  if (const std::string ties = Ties(parameters); !ties.empty()) advice.push_back(ties);
  advice.insert(advice.end(), remarks.further.begin(), remarks.further.end());
  if (overview.explained == Explained::kNo) advice.push_back(OnMisfit(result, remarks, overview));
  if (CountOf(overview.unseen, Follows::kNot) > 0)
    advice.push_back(
        "The model does not predict the validation recordings. Use a richer model, or fit recordings that reach the "
        "same frequencies and strokes.");
  if (!advice.empty()) return advice;
  if (overview.IsExplained())
    return {overview.disagree.empty()
                ? "Nothing is missing for this model; a richer one would need more data."
                : "No more is missing than the stated model error allows; a smaller one asks for a richer model."};
  if (overview.explained == Explained::kNearly)
    return {"Little is missing. Fit a richer model to the same recordings to find what explains the rest."};
  if (!remarks.where_not_weighed.empty()) return {remarks.where_not_weighed};
  return {"The run holds no misfit. Fit again to have it assessed."};
}

/// Of the inputs and the residuals; none of older runs.
std::string WarningsHtml(const Json& result) {
  const std::vector<Json> warnings = ListAt(result, "warnings");
  std::string items;
  for (const Json& warning : warnings)
    if (const std::string text = FindingText(warning); !text.empty()) items += html::Element("li", "", CodeHtml(text));
  return html::Folded(Counted(warnings.size(), "warning") + " about inputs and residuals",
                      items.empty() ? "" : html::Element("ul", "", items));
}

}  // namespace

std::string SummaryHtml(const Json& result, const FitOverview& overview,
                        const std::vector<ReportedParameter>& parameters, const ReportRemarks& remarks) {
  std::string misses = WhatDoesNot(overview.channels);
  if (misses.empty() && !overview.channels.empty()) misses = "All fitted channels are within tolerance. ";
  misses += WhatItMisses(overview.unseen);
  std::string next;
  for (const std::string& advice : WhatNext(result, parameters, remarks, overview))
    next += html::Element("li", "", advice);
  const std::string missing =
      Sentences(remarks.missing_force, WhatIsMissing(result, overview.explained == Explained::kNo));
  const std::string predicts =
      Sentences(WhatItPredicts(ListAt(result, "validation"), overview.unseen), WhatWasLeftOut(result));
  const bool is_interrupted = TextAt(result, "termination") == "interrupted";
  return TilesHtml(overview, parameters) + html::Drawn("overview") +
         html::Element("p", "verdict " + overview.verdict, VerdictHtml(result, overview)) +
         "\n<dl class=\"summary\">\n" + Item("What fits", WhatFits(overview.channels)) +
         Item("What does not fit", misses) + Item("What is missing", missing) + Item("How it grew", HowItGrew(result)) +
         Item("What it predicts", predicts) + Item("What is determined", WhatIsDetermined(parameters)) +
         Item("What is not determined", WhatIsNot(result, parameters, remarks)) +
         Item(is_interrupted ? "What to do next" : "What to measure next", html::Element("ul", "", next)) + "</dl>\n" +
         WarningsHtml(result) + html::Folded("How it was modelled", ModelledHtml(remarks.modelled));
}

}  // namespace fourpost
