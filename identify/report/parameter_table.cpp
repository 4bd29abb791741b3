#include "identify/report/parameter_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/files/json_text.h"
#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "analysis/signals/median.h"
#include "analysis/text/counted.h"
#include "identify/report/sentences_html.h"

namespace fourpost {
namespace {

using html::Cell;
using html::NumberCell;
using html::TextCell;
using Json = nlohmann::json;
using Rows = std::vector<std::vector<Cell>>;

std::string Percent(double share) { return ShownDecimals(100 * share, 2) + '%'; }

/// Where a value lies between the bounds, 0 to 1.
double ShareOfRange(const ReportedParameter& parameter, double value) {
  return std::clamp((value - parameter.lower) / (parameter.upper - parameter.lower), 0.0, 1.0);
}

/// Whether the interval reaches beyond a bound.
bool BelowLower(const ReportedParameter& parameter) {
  return std::isfinite(parameter.sd) && parameter.lower_95 < parameter.lower;
}
bool AboveUpper(const ReportedParameter& parameter) {
  return std::isfinite(parameter.sd) && parameter.upper_95 > parameter.upper;
}

/// Whether an end of the interval is the bound: it would reach beyond.
bool IsCutBelow(const ReportedParameter& parameter) {
  return std::isfinite(parameter.sd) && parameter.lower_95 <= parameter.lower;
}
bool IsCutAbove(const ReportedParameter& parameter) {
  return std::isfinite(parameter.sd) && parameter.upper_95 >= parameter.upper;
}

/// "1 631 … 1 967"; an end that a bound cuts is the bound, marked by an arrow.
Cell IntervalCell(const ReportedParameter& parameter, int decimals) {
  if (std::isinf(parameter.sd)) return {"open", "n"};
  if (!std::isfinite(parameter.sd)) return {"", "n"};
  const auto end = [&](double value, bool is_cut) {
    return is_cut ? ShownShort(value, 4) : ShownDecimals(value, decimals);
  };
  const bool below = IsCutBelow(parameter);
  const bool above = IsCutAbove(parameter);
  const std::string text = (below ? "\u2190\u202f" : "") + end(std::max(parameter.lower_95, parameter.lower), below) +
                           " \u2026 " + end(std::min(parameter.upper_95, parameter.upper), above) +
                           (above ? "\u202f\u2192" : "");
  return {html::Escaped(text), "n"};
}

Cell BarCell(const ReportedParameter& parameter) {
  if (!(parameter.upper > parameter.lower)) return TextCell("");
  // Open: anything between the bounds.
  const double from = std::isfinite(parameter.sd) ? ShareOfRange(parameter, parameter.lower_95) : 0;
  const double to = std::isfinite(parameter.sd) ? ShareOfRange(parameter, parameter.upper_95) : 1;
  std::string bar = "<span class=\"bar\" title=\"between the bounds: interval, fitted value, start\">";
  if (!std::isnan(parameter.sd))
    bar += "<i class=\"interval" + std::string(std::isinf(parameter.sd) ? " open" : "") +
           (IsCutBelow(parameter) ? " below" : "") + (IsCutAbove(parameter) ? " above" : "") +
           "\" style=\"left:" + Percent(from) + ";width:" + Percent(to - from) + "\"></i>";
  if (std::isfinite(parameter.start))
    bar += "<i class=\"start\" style=\"left:" + Percent(ShareOfRange(parameter, parameter.start)) + "\"></i>";
  bar += "<i class=\"value\" style=\"left:" + Percent(ShareOfRange(parameter, parameter.value)) + "\"></i></span>";
  return {bar, "barcell"};
}

std::string Determined(const ReportedParameter& parameter) {
  if (parameter.state == ParameterState::kNoise) return "derivative is noise";
  if (parameter.state == ParameterState::kAtBound) return "held by its " + parameter.BoundName() + " bound";
  if (std::isnan(parameter.sd)) return "";
  if (std::isinf(parameter.sd) || parameter.state == ParameterState::kUndetermined) return "not determined";
  if (parameter.at_bound) return "held by its bound";
  const double sd = parameter.RelativeSd();
  return sd <= 0.02 ? "well determined" : sd <= 0.1 ? "determined" : "weakly determined";
}

/// What limits an interval, in words, and what would make it narrower.
struct Limit {
  std::string text;
  std::string remedy;
};

/// "2.4 .. 4.8 Hz" as "2.4 to 4.8 Hz".
std::string InWords(std::string text) {
  for (std::size_t at = text.find(" .. "); at != std::string::npos; at = text.find(" .. ", at))
    text.replace(at, 4, " to ");
  return text;
}

/// `limited_by`: of a result, as "model: 2.4 .. 4.8 Hz".
Limit LimitOf(const std::string& limited_by) {
  const std::size_t colon = limited_by.find(": ");
  const std::string kind = limited_by.substr(0, colon);
  const std::string name = colon == std::string::npos ? "" : InWords(limited_by.substr(colon + 2));
  if (kind == "noise") return {"limited by noise", "Measure longer or more often."};
  if (kind == "stated error")
    return {"limited by the stated error",
            "Residuals are far below the stated error: state a smaller one if you trust the model so far."};
  if (kind == "model")
    return {"limited by the model (" + name + ")",
            "These data ask for another value than the rest: check them; if they are right, add to the model what they "
            "ask for."};
  if (kind == "missing")
    return {"limited by what the model lacks (" + name + ")", "Add it to the model, and fit again."};
  if (kind == "held") return {"limited by the held " + name, "Measure " + name + ", or free it."};
  if (kind == "calibration")
    return {"limited by the calibration of " + name,
            "Calibrate " + name + " and state the smaller standard deviation."};
  return {"limited by " + InWords(limited_by), ""};
}

Cell RemarkCell(const ReportedParameter& parameter) {
  std::string remark = Determined(parameter);
  const bool is_said = parameter.state == ParameterState::kAtBound || std::isfinite(parameter.sd);
  if (parameter.at_bound && !is_said)
    remark += (remark.empty() ? "" : ", ") + std::string("at its ") + parameter.BoundName() + " bound";
  const bool below = BelowLower(parameter);
  const bool above = AboveUpper(parameter);
  if ((below || above) && !parameter.at_bound)
    remark += std::string(", interval reaches beyond ") + (below && above ? "both bounds"
                                                           : below        ? "the lower bound"
                                                                          : "the upper bound");
  if (!parameter.CutAt().empty()) remark += ", interval cut at " + std::string(parameter.CutAt());
  if (!parameter.limited_by.empty() && std::isfinite(parameter.sd))
    remark += (remark.empty() ? "" : ", ") + LimitOf(parameter.limited_by).text;
  constexpr double kHeldCounts = 1.5;
  if (std::isfinite(parameter.held_factor) && parameter.held_factor > kHeldCounts)
    remark += " (" + ShownNumber(parameter.held_factor, 2) + " times smaller if that were known)";
  std::string cell = html::Escaped(remark);
  if (const std::string remedy = LimitOf(parameter.limited_by).remedy; !remedy.empty() && std::isfinite(parameter.sd))
    cell = "<span title=\"" + html::Escaped(remedy) + "\">" + cell + "</span>";
  if (std::abs(parameter.correlation) > 0.8 && std::isfinite(parameter.sd))
    cell += (cell.empty() ? "" : "; ") + std::string("correlated with ") +
            html::Element("code", "", html::Escaped(parameter.partner)) + " (" +
            ShownDecimals(parameter.correlation, 2) + ")";
  const bool calls = parameter.at_bound || parameter.state == ParameterState::kNoise || std::isinf(parameter.sd) ||
                     parameter.RelativeSd() > 0.1;
  return {cell, calls ? "remark calls" : "remark"};
}

std::vector<Cell> ParameterRow(const ReportedParameter& parameter, bool has_sd) {
  const int decimals = DecimalsFor(parameter.value, parameter.sd);
  const int coarse = DecimalsFor(parameter.value, NAN);
  std::vector<Cell> row = {{html::Element("code", "", html::Escaped(parameter.name)), ""},
                           NumberCell(ShownDecimals(parameter.start, std::min(decimals, coarse))),
                           {html::Element("b", "", ShownDecimals(parameter.value, decimals)), "n"}};
  if (has_sd) {
    row.push_back(SdCell(parameter.sd, decimals));
    row.push_back(IntervalCell(parameter, decimals));
  }
  row.push_back(TextCell(ShownUnit(parameter.unit)));
  if (has_sd) row.push_back(NumberCell(ShownNumber(100 * parameter.RelativeSd(), 2)));
  row.insert(row.end(), {NumberCell(ShownShort(parameter.lower, 4)),
                         BarCell(parameter),
                         {html::Escaped(ShownShort(parameter.upper, 4)), ""},
                         RemarkCell(parameter)});
  return row;
}

std::vector<std::string> ParameterHead(bool has_sd, const std::string& confidence) {
  if (!has_sd) return {"parameter", "start", "fitted", "unit", "lower", "between the bounds", "upper", ""};
  return {"parameter",          "start", "fitted",    "sd", "interval of " + confidence, "unit", "sd, %", "lower",
          "between the bounds", "upper", "assessment"};
}

/// "80 to 90 %", which may break nowhere.
std::string ShownConfidence(std::string text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at)) text.replace(at, 1, "\u00a0");
  return text;
}

/// How far the data disagree, and what that costs.
std::string WhyWide(const FitOverview& overview, const std::vector<ReportedParameter>& parameters) {
  if (overview.disagree.empty()) return "";
  std::vector<double> shares;
  for (const ReportedParameter& parameter : parameters)
    if (std::isfinite(parameter.noise_factor)) shares.push_back(parameter.noise_factor);
  // Runs of older versions do not hold it.
  const double wider = std::isfinite(overview.wider_than_by_noise) ? overview.wider_than_by_noise
                       : shares.empty()                            ? std::nan("")
                                                                   : Median(shares);
  const std::string advice = AdviceOnDisagreement(overview);
  std::string text = CodeHtml(DisagreementSentence(overview)) + (advice.empty() ? "" : " " + advice);
  if (std::isfinite(wider))
    text += " By noise alone the intervals would be " + ShownNumber(wider, 2) + " times narrower.";
  return html::Element("p", "", text) + '\n';
}

/// What would narrow the intervals of parameters that are limited so: "model", "held", ...
std::string RemedyFor(const std::string& kind) {
  if (kind == "noise") return "Measure longer or more often";
  if (kind == "stated error") return "State a smaller error if you trust the model so far: residuals are far below it";
  if (kind == "model") return "Check these data; if they are right, add to the model what they ask for";
  if (kind == "missing") return "Add to the model what it lacks, and fit again";
  if (kind == "held") return "Measure or free these held parameters";
  if (kind == "calibration") return "Calibrate these, and state the smaller standard deviation";
  return "Reduce what limits them";
}

/// Things in the order in which they came up, each with what belongs to it.
using Grouped = std::vector<std::pair<std::string, std::vector<std::string>>>;

std::vector<std::string>& Of(const std::string& name, Grouped& groups) {
  const auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group.first == name; });
  if (known != groups.end()) return known->second;
  groups.emplace_back(name, std::vector<std::string>());
  return groups.back().second;
}

std::string Listed(const std::vector<std::string>& html) {
  std::string text;
  for (const std::string& one : html) text += (text.empty() ? "" : ", ") + one;
  return text;
}

/// Parameters by what would narrow their intervals, and by the part of the data or the thing that it is to be done to.
std::string RemediesHtml(const std::vector<ReportedParameter>& parameters) {
  Grouped kinds;
  Grouped named;
  for (const ReportedParameter& parameter : parameters) {
    if (parameter.limited_by.empty() || !std::isfinite(parameter.sd)) continue;
    std::vector<std::string>& of_kind = Of(parameter.limited_by.substr(0, parameter.limited_by.find(": ")), kinds);
    if (std::find(of_kind.begin(), of_kind.end(), parameter.limited_by) == of_kind.end())
      of_kind.push_back(parameter.limited_by);
    Of(parameter.limited_by, named).push_back(html::Code(parameter.name));
  }
  std::string items;
  for (const auto& [kind, limits] : kinds) {
    std::vector<std::string> parts;
    for (const std::string& limited_by : limits) {
      const std::size_t colon = limited_by.find(": ");
      const std::string name = colon == std::string::npos ? "" : InWords(limited_by.substr(colon + 2));
      parts.push_back(html::Escaped(name) + (name.empty() ? "" : " for ") + Listed(Of(limited_by, named)));
    }
    std::string list;
    for (const std::string& part : parts) list += html::Element("li", "", part);
    items += html::Element(
        "li", "",
        html::Escaped(RemedyFor(kind)) + ": " + (parts.size() == 1 ? parts.front() : html::Element("ul", "", list)));
  }
  return items.empty() ? "" : html::Element("ul", "remedies", items) + '\n';
}

/// Recordings that want other values than the rest: the first, and the others on demand.
std::string ContradictionsHtml(const std::vector<ReportedParameter>& parameters, const std::vector<Json>& found) {
  constexpr std::size_t kShown = 3;
  std::string first;
  std::string rest;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string name = TextAt(found[i], "parameter");
    const double shift = NumberAt(found[i], "shift");
    const auto parameter = std::find_if(parameters.begin(), parameters.end(),
                                        [&](const ReportedParameter& candidate) { return candidate.name == name; });
    if (parameter == parameters.end() || !std::isfinite(shift)) continue;
    const bool is_relative = parameter->lower > 0;
    const double percent = 100 * (is_relative ? std::expm1(shift) : shift);
    (i < kShown ? first : rest) += html::Element(
        "li", "",
        "Without " + html::Code(TextAt(found[i], "without")) + ' ' + html::Code(name) + " would change by " +
            (percent > 0 ? "+" : "") + ShownNumber(percent, 2) + " %" + (is_relative ? "" : " of its range") + " (" +
            ShownNumber(NumberAt(found[i], "in_sd_of_noise"), 2) + " standard deviations of noise).");
  }
  if (first.empty()) return "";
  return "<p>Recordings contradict each other beyond noise:</p>\n" + html::Element("ul", "", first) +
         (rest.empty() ? ""
                       : "<details><summary>all of them</summary>" + html::Element("ul", "", rest) + "</details>") +
         '\n';
}

}  // namespace

std::string ParameterTableHtml(const std::vector<ReportedParameter>& parameters, const std::string& why_none,
                               const std::string& stated) {
  const bool has_sd =
      std::any_of(parameters.begin(), parameters.end(), [](const auto& parameter) { return parameter.IsJudged(); });
  const bool lacks = std::any_of(parameters.begin(), parameters.end(), [](const ReportedParameter& parameter) {
    return parameter.limited_by.starts_with("model") || parameter.limited_by.starts_with("missing");
  });
  // Of runs of older versions.
  const std::string confidence = ShownConfidence(!stated.empty() ? stated : lacks ? "80 to 90 %" : "95 %");
  Rows rows;
  for (const ReportedParameter& parameter : parameters) rows.push_back(ParameterRow(parameter, has_sd));
  if (rows.empty()) return "";
  const std::string bar =
      "Bar: the interval between the bounds, with an arrow where a bound cuts it off (\u2190, "
      "\u2192 beside the number); dot: fitted value; tick: start. ";
  return html::Table(ParameterHead(has_sd, confidence), rows) +
         html::Element(
             "p", "note",
             has_sd ? "Interval: holds the true value in " + confidence + " of cases. " + bar +
                          "\"sd, %\": of the value, or of the range where the bounds have both signs. " +
                          (lacks ? "Parts of the data ask for different parameters, by more than noise explains, and "
                                   "standard deviations and intervals allow for that. A richer model can narrow them."
                                 : "Standard deviations follow from noise, held parameters and the stated model "
                                   "error, scaled up where residuals are larger.")
                    : "Bar: the bounds; dot: fitted value; tick: start. " + html::Escaped(why_none)) +
         '\n';
}

std::string IntervalBasisHtml(const std::vector<ReportedParameter>& parameters, const Json& result,
                              const FitOverview& overview) {
  const Json intervals = result.value("intervals", Json());
  if (!intervals.is_object()) return "";
  const std::string html = WhyWide(overview, parameters) + RemediesHtml(parameters) +
                           ContradictionsHtml(parameters, ListAt(intervals, "contradictions"));
  return html.empty() ? "" : "<h3>What would narrow the intervals</h3>\n" + html;
}

}  // namespace fourpost
