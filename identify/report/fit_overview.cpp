#include "identify/report/fit_overview.h"

#include <algorithm>
#include <cmath>

#include "analysis/files/json_text.h"
#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"
#include "identify/fit/fit_result.h"
#include "identify/study_file/result_reader.h"
#include "identify/uncertainty/misfit_limits.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

/// Runs of older versions hold what deviations were multiplied by, which is the same where no loss bounds the pull of
/// outliers.
double WholeMisfit(const Json& result) {
  const double misfit = NumberAt(result, "misfit");
  return std::isfinite(misfit) ? misfit : NumberAt(result.value("identifiability", Json()), "sd_inflation");
}

Explained ExplainedBy(double misfit) {
  if (!std::isfinite(misfit)) return Explained::kUnknown;
  if (misfit < kSmallMisfit) return Explained::kOverstated;
  if (misfit <= kExplainedMisfit) return Explained::kYes;
  return misfit <= kLargeMisfit ? Explained::kNearly : Explained::kNo;
}

bool IsAnyPoor(const std::vector<JudgedChannel>& channels) {
  return std::any_of(channels.begin(), channels.end(),
                     [](const JudgedChannel& channel) { return channel.follows == Follows::kNot; });
}

void AddDisagreement(const Json& result, FitOverview& overview) {
  const Json intervals = result.value("intervals", Json());
  overview.wider_than_by_noise = NumberAt(intervals, "wider_than_by_noise");
  if (!intervals.is_object() || intervals.value("model_error", Json()) != true) return;
  for (const Json& way : ListAt(intervals, "ways")) {
    // Runs of older versions do not say which are.
    if (!way.is_object() || way.value("is_beyond_noise", Json(true)) != true) continue;
    overview.disagree.push_back(TextAt(way, "by"));
    overview.disagreement.push_back(std::sqrt(NumberAt(way, "disagreement")));
  }
}

std::string VerdictOf(const Json& result, const FitOverview& overview) {
  const std::string end = TextAt(result, "termination");
  const Json verdict = result.value("verdict", Json());
  const Json growth = result.value("growth", Json());
  const bool is_interrupted = growth.is_object() && growth.value("interrupted", Json()) == true;
  if (end == "interrupted") return "open";
  if (end != "converged" || !ListAt(verdict, "reasons").empty()) return "poor";
  if (is_interrupted) return "open";
  const Json starts = result.value("starts", Json());
  const bool is_alone = NumberAt(starts, "refined") > 1 && NumberAt(starts, "agreeing") < 2;
  const bool is_fair = overview.explained == Explained::kNo || IsAnyPoor(overview.channels) ||
                       IsAnyPoor(overview.unseen) || (!overview.disagree.empty() && !overview.IsExplained()) ||
                       !ListAt(verdict, "accepted").empty() || is_alone;
  return is_fair ? "fair" : "good";
}

std::string Quoted(const std::string& name) { return '`' + name + '`'; }

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Runs of older versions hold no such number; that of the data's degrees of freedom is the same where no recorded
/// input has noise, and no parameter a prior.
double ExpectedSquares(const Json& result) {
  const double expected = NumberAt(result, "expected_squares");
  if (std::isfinite(expected)) return expected;
  return NumberAt(result, "residuals") - NumberAt(result.value("identifiability", Json()), "rank");
}

}  // namespace

FitOverview OverviewOf(const Json& result) {
  FitOverview overview{.misfit = WholeMisfit(result)};
  overview.expected_squares = ExpectedSquares(result);
  overview.explained = ExplainedBy(overview.misfit);
  overview.is_calibrated = !ListAt(result.value("intervals", Json()), "calibrations").empty();
  overview.is_mostly_post_noise = NumberAt(result, "post_noise_share") > kMostlyInputNoise;
  overview.channels = JudgeChannels(ListAt(result, "channels"));
  overview.unseen = JudgeChannels(ListAt(result, "validation"));
  AddDisagreement(result, overview);
  overview.verdict = VerdictOf(result, overview);
  return overview;
}

std::string VerdictWord(const FitOverview& overview) {
  return overview.verdict == "open" ? "not finished" : overview.verdict;
}

std::string AdviceOnDisagreement(const FitOverview& overview) {
  if (overview.disagree.empty() || overview.IsExplained()) return "";
  return "First check what was measured (gain, sign, delay, position and noise of each channel and post); if it is "
         "right, the model lacks something.";
}

std::string ResidualSentence(const FitOverview& overview) {
  if (overview.explained == Explained::kUnknown) return "";
  const std::string are = "Residuals are " + Rounded(overview.misfit, 2) + " times what noise" +
                          (overview.is_mostly_post_noise ? ", most of it of the recorded posts," : "") +
                          " and the stated model error explain" + (overview.is_calibrated ? ", calibrated" : "");
  if (overview.explained == Explained::kYes) return are + ": as a whole these explain the residuals.";
  if (overview.explained != Explained::kOverstated) return are + "; about 1 is expected.";
  // Where parts of the data disagree, intervals follow from that.
  return are + (overview.disagree.empty()
                    ? ": state smaller ones, such as `model_error`; intervals of stepped sines follow from them."
                    : ": these are more than explain the residuals.");
}

std::string WorstSentence(const FitOverview& overview) {
  const JudgedChannel* const worst = overview.Worst();
  if (worst == nullptr) return "";
  std::string text = "Worst channel: " + Quoted(worst->name) + ", " +
                     (std::isfinite(worst->misfit) ? Rounded(worst->misfit, 2) + " times noise and stated model error"
                                                   : worst->numbers);
  if (worst->worst)
    text += "; largest in " + Quoted(worst->worst->recording) + " from " + ShortNumber(worst->worst->lower_Hz, 3) +
            " to " + ShortNumber(worst->worst->upper_Hz, 3) + " Hz (" + Rounded(worst->worst->misfit, 2) +
            " times there)";
  return text + '.';
}

std::string DisagreementSentence(const FitOverview& overview) {
  if (overview.disagree.empty()) return "";
  return "Parts of the data (" + Joined(overview.disagree) + ") " +
         (overview.IsExplained() ? "still ask for different parameters, by no more than the stated model error allows"
                                 : "ask for different parameters, beyond noise") +
         "; the intervals allow for that.";
}

nlohmann::ordered_json OverviewJson(const FitOverview& overview) {
  nlohmann::ordered_json worst = nullptr;
  if (const JudgedChannel* const channel = overview.Worst()) {
    worst = {{"name", channel->name}, {"misfit", NumberOrNull(channel->misfit)}, {"place", nullptr}};
    if (channel->worst)
      worst["place"] = {{"recording", channel->worst->recording},
                        {"band_Hz", {channel->worst->lower_Hz, channel->worst->upper_Hz}},
                        {"misfit", channel->worst->misfit}};
  }
  return {{"verdict", overview.verdict},
          {"misfit", NumberOrNull(overview.misfit)},
          {"expected_squares", NumberOrNull(overview.expected_squares)},
          {"is_calibrated", overview.is_calibrated},
          {"worst", worst}};
}

}  // namespace fourpost
