#include "identify/run/fit_text.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/text/number.h"
#include "analysis/text/text_table.h"
#include "identify/run/parameter_limit.h"

namespace fourpost {
namespace {

/// In the unit of the vehicle file, at digits that suit standard deviations of some per mille.
std::string Shown(double value, const std::string& unit) { return InUnit(value, unit, 4); }

std::string Deviation(const FittedParameter& parameter) {
  if (std::isnan(parameter.sd)) return "-";
  return std::isinf(parameter.sd) ? "undetermined" : Shown(parameter.sd, parameter.unit);
}

std::string IntervalText(const FittedParameter& parameter) {
  if (!std::isfinite(parameter.sd)) return "";
  return Shown(parameter.lower_95, parameter.unit) + " .. " + Shown(parameter.upper_95, parameter.unit);
}

/// What deserves a second look.
std::string Remark(const FittedParameter& parameter) {
  // A good prior is this far off in one fit of twenty.
  constexpr double kFar = 2;
  std::string remark = parameter.at_bound ? "at " + std::string(parameter.BoundName()) + " bound" : "";
  const auto add = [&](const std::string& text) { remark += (remark.empty() ? "" : ", ") + text; };
  if (parameter.state == ParameterState::kUndetermined && std::isfinite(parameter.sd)) add("not determined");
  if (!parameter.CutAt().empty()) add("interval cut at " + std::string(parameter.CutAt()));
  if (parameter.state == ParameterState::kNoise) add("derivative is noise");
  if (const double distance = std::abs(parameter.FromPrior()); distance > kFar)
    add(Rounded(distance, 2) + " sd from prior");
  if (const double distance = std::abs(parameter.from_like); distance > kFar)
    add(Rounded(distance, 2) + " sd from its ratio to " + parameter.like->parameter);
  // Above it most of the doubt is that of held parameters and calibrations.
  constexpr double kHeldCounts = 1.5;
  const double factor = parameter.sd / std::hypot(parameter.noise_sd, parameter.model_sd);
  if (std::isfinite(factor) && factor > kHeldCounts)
    remark += (remark.empty() ? "sd " : ", sd ") + Rounded(factor, 2) + " times smaller if that were known";
  return remark;
}

std::string ParameterTable(const FitResult& fit) {
  TextTable table({"parameter", "start", "fitted", "sd", fit.certainty ? fit.certainty->Confidence() : "95 %", "lower",
                   "upper", "unit", "limited by", ""});
  for (const FittedParameter& p : fit.parameters)
    table.Add({p.name, Shown(p.start, p.unit), Shown(p.value, p.unit), Deviation(p), IntervalText(p),
               Shown(p.lower, p.unit), Shown(p.upper, p.unit), p.unit, LimitOf(fit, p), Remark(p)});
  return table.Format();
}

/// Recordings that want other values than the rest.
std::string RecordingContradictions(const FitResult& fit) {
  constexpr std::size_t kShown = 3;
  if (!fit.certainty) return "";
  const std::vector<std::string>& recordings = fit.certainty->model_error.by_recording.clusters;
  const std::vector<Contradiction> found = fit.certainty->Contradictions();
  if (found.empty()) return "";
  std::string text = "Recordings contradict each other beyond noise:\n";
  for (std::size_t i = 0; i < std::min(kShown, found.size()); ++i) {
    const FittedParameter& p = fit.parameters[static_cast<std::size_t>(found[i].parameter)];
    const double change_percent = 100 * (p.lower > 0 ? std::expm1(found[i].shift) : found[i].shift);
    text += "  without '" + recordings[static_cast<std::size_t>(found[i].cluster)] + "' " + p.name +
            " would change by " + Rounded(change_percent, 2) + " %" + (p.lower > 0 ? "" : " of its range") + " (" +
            Rounded(found[i].deviations, 2) + " standard deviations of noise)\n";
  }
  if (found.size() > kShown)
    text += "  and " + std::to_string(found.size() - kShown) + " more: `intervals.contradictions` in result.json\n";
  return text;
}

/// Sentences of an overview, with names as messages have them, in lines of a terminal.
std::string WrappedForTerminal(std::string sentence) {
  constexpr std::size_t kWidth = 118;
  std::replace(sentence.begin(), sentence.end(), '`', '\'');
  std::string text;
  std::size_t column = 0;
  std::istringstream words(sentence);
  for (std::string word; words >> word;) {
    const bool is_new = column > 0 && column + 1 + word.size() > kWidth;
    text += column == 0 ? "" : is_new ? "\n" : " ";
    column = is_new ? word.size() : column + (column > 0) + word.size();
    text += word;
  }
  return text.empty() ? "" : text + '\n';
}

/// Why the intervals are as wide as they are.
std::string IntervalBasis(const FitOverview& overview) {
  if (overview.disagree.empty()) return "";
  std::string ways;
  for (std::size_t i = 0; i < overview.disagree.size(); ++i)
    ways += (ways.empty() ? "  Parameters differ between " : ", between ") + overview.disagree[i] + " " +
            Rounded(overview.disagreement[i], 2) + " times" + (ways.empty() ? " as much as noise explains" : "");
  return WrappedForTerminal(DisagreementSentence(overview)) + WrappedForTerminal(AdviceOnDisagreement(overview)) +
         ways + ".\n  By noise alone the intervals would be " + Rounded(overview.wider_than_by_noise, 2) +
         " times narrower.\n"
         "  Limited by noise: measure longer or more often; by the stated error: state a smaller one if you trust the\n"
         "  model so far; by the model: add what those data ask for; by a held parameter: free or measure it.\n";
}

std::string CalibrationTable(const FitResult& fit) {
  if (!fit.certainty || fit.certainty->calibrations.empty()) return "";
  TextTable table({"calibration", "stated sd", "with the data", "sd", ""});
  for (const CalibrationEstimate& one : fit.certainty->calibrations)
    table.Add({one.name, InstrumentNumber(one.sd, one.unit), InstrumentNumber(one.estimate, one.unit),
               InstrumentNumber(one.estimate_sd, one.unit), IsSurprising(one) ? "beyond what is stated" : ""});
  return table.Format() + "Costs, errors and curves are of the channels as recorded.\n\n";
}

/// As far as noise alone goes, which is what a profile sees.
std::string NoiseInterval(const FitResult& fit, const FittedParameter& p) {
  if (!std::isfinite(p.noise_sd)) return "";
  const double reach = fit.covariance->reach_95 * p.noise_sd;
  const double lower = p.lower > 0 ? p.value * std::exp(-reach / p.value) : p.value - reach;
  const double upper = p.lower > 0 ? p.value * std::exp(reach / p.value) : p.value + reach;
  return Shown(lower, p.unit) + " .. " + Shown(upper, p.unit);
}

std::string ProfileTable(const FitResult& fit) {
  if (fit.profiles.empty()) return "";
  TextTable table({"profile", "fitted", "95 % by noise", "95 % by profile", "unit", ""});
  for (const Profile& profile : fit.profiles) {
    const FittedParameter& p = *std::find_if(fit.parameters.begin(), fit.parameters.end(),
                                             [&](const FittedParameter& other) { return other.name == profile.name; });
    const auto end = [&](double value) { return std::isfinite(value) ? Shown(value, p.unit) : std::string("open"); };
    const std::string remark = profile.interrupted    ? "interrupted"
                               : profile.found_better ? "found a lower cost than the fit: not its best optimum"
                                                      : "";
    table.Add({p.name, Shown(p.value, p.unit), NoiseInterval(fit, p),
               end(profile.lower_95) + " .. " + end(profile.upper_95), p.unit, remark});
  }
  return table.Format() + '\n';
}

std::string PriorShare(const FitResult& fit) {
  if (fit.prior_count == 0) return "";
  return ", of which priors " + Rounded(fit.prior_cost, 3) + " for " + std::to_string(fit.prior_count);
}

std::string LossWords(const RobustLoss& loss) {
  if (loss.kind() == LossKind::kNone) return "";
  return " by " + std::string(loss.name()) + " beyond " + FormatNumber(loss.scale()) + " sd";
}

std::string Agreement(const FitResult& fit) {
  const bool is_cut_short = fit.end == FitEnd::kInterrupted;
  if (is_cut_short && fit.starts == 0) return "stopped before any refinement ended";
  return std::to_string(fit.agreeing) + " of " + std::to_string(fit.starts) + " refinements " +
         (is_cut_short ? "that ended agree" : "agree");
}

std::string GainText(const std::string& what, const SearchGain& gain) {
  if (gain.count == 0) return "";
  return ", " + std::to_string(gain.count) + " " + what + (gain.count == 1 ? "" : "s") + " in " +
         std::to_string(gain.evaluations) + " evaluations (" + std::to_string(gain.successes) +
         " lowered the best cost)";
}

/// Empty for a refinement without a search.
std::string SearchText(const FitResult& fit) {
  const SearchResult& search = fit.search;
  if (search.end == SearchEnd::kNotRun) return "";
  return "search by " + std::string(AlgorithmName(fit.options.search)) +
         (search.end == SearchEnd::kStopped ? " " : " ended by ") + search.reason +
         GainText("acceleration", search.accelerations) + GainText("migration", search.migrations) + '\n';
}

/// They led the refinements.
std::string CoarseText(const FitResult& fit) {
  if (fit.coarse_evaluations == 0) return "";
  return "; " + std::to_string(fit.coarse_evaluations) + " more with a quarter of the frequencies";
}

/// "fit converged" only for one that explains the data.
std::string Summary(const FitResult& fit, const FitVerdict& verdict) {
  const EvaluationCounts& counts = fit.evaluations;
  return (verdict.explains() ? "fit " : "search and refinement ") + std::string(FitEndName(fit.end)) + ": cost " +
         Rounded(fit.cost, 5) + LossWords(fit.options.refine.loss) + " for " + std::to_string(fit.residual_count) +
         " residuals" + PriorShare(fit) + "; " + std::to_string(counts.paid) + " new evaluations, " +
         std::to_string(counts.reused) + " reused, " + std::to_string(counts.failed()) + " failed" + CoarseText(fit) +
         "; " + Agreement(fit) + '\n' + SearchText(fit);
}

/// "c_bump -15 %, k +11 %"
std::string MovesText(const nlohmann::ordered_json& moves) {
  constexpr std::size_t kShown = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, moves.size()); ++i)
    text += (text.empty() ? "" : ", ") + moves[i]["name"].get<std::string>() + ' ' +
            (moves[i]["percent"].get<double>() > 0 ? "+" : "") + Rounded(moves[i]["percent"], 2) + " %";
  return text + (moves.size() > kShown ? ", ..." : "");
}

/// What additions together would do to the parameters.
std::string TogetherText(const nlohmann::ordered_json& together) {
  if (together["additions"].empty() || together["moves"].empty()) return "";
  std::string text = "Together these would move the parameters, and the intervals reach there:\n";
  for (const auto& one : together["additions"]) text += "  + " + one.get<std::string>() + '\n';
  return text + "  " + MovesText(together["moves"]) +
         "\n  `fourpost fit STUDY -o DIR --grow` adds step by step what lowers BIC, and fits again.\n";
}

/// "  dry friction beside damper 'front', 149 N: lowers the cost by 48 %"
std::string MissingText(const nlohmann::ordered_json& missing, bool is_large) {
  if (missing.is_null()) return "";
  const std::string together = TogetherText(missing["together"]);
  if (missing["suggestions"].empty())
    return (is_large && together.empty()
                ? "Of " + FormatNumber(missing["tried"].get<double>()) + " additions to the model none explains it.\n"
                : "") +
           together;
  std::string text = "The model probably lacks, each alone (`fourpost suggest` lists all):\n";
  for (const auto& one : missing["suggestions"]) {
    // What only moves a part has no number of its own.
    const auto expected = one["expected"].get<std::string>();
    text += "  " + one["text"].get<std::string>() + (expected.empty() ? "" : ", " + expected) +
            ": lowers the cost by " + Rounded(one["fall_percent"], 2) + " %\n";
  }
  return text + together;
}

/// What the fit is worth, what could explain the residuals, and the direction that the data determine least.
std::string Judgement(const FitResult& fit, const FitOverview& overview, const nlohmann::ordered_json& missing) {
  if (!fit.covariance) return "";
  const Covariance& covariance = *fit.covariance;
  std::string text = WrappedForTerminal("Fit: " + VerdictWord(overview) + ". " + ResidualSentence(overview)) +
                     WrappedForTerminal(WorstSentence(overview)) +
                     MissingText(missing, overview.explained == Explained::kNo);
  if (covariance.rank < covariance.directions.cols() || covariance.directions.cols() < 2) return text;
  text += "Least identifiable direction (condition number " + Rounded(covariance.condition, 2) + "):\n";
  for (const std::string& combination : fit.weakest) text += "  " + combination + "\n";
  return text;
}

}  // namespace

std::string InstrumentNumber(double value, const std::string& unit) {
  if (unit == "1") return Rounded(100 * value, 2) + " %";
  return unit == "s" ? Rounded(1e3 * value, 2) + " ms" : Rounded(value, 3) + " N";
}

std::string FitText(const FitResult& fit, const FitOverview& overview, const FitVerdict& verdict,
                    const Diagnostics& conclusions, const std::string& sections,
                    const nlohmann::ordered_json& missing) {
  const std::string basis = IntervalBasis(overview) + RecordingContradictions(fit);
  return ParameterTable(fit) + '\n' + basis + (basis.empty() ? "" : "\n") + ProfileTable(fit) + CalibrationTable(fit) +
         sections + Summary(fit, verdict) + Judgement(fit, overview, missing) +
         (conclusions.items().empty() ? "" : conclusions.Format() + '\n');
}

}  // namespace fourpost
