#include "identify/experiments/four_post/missing_force_section.h"

#include <cmath>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

std::string BandOf(const nlohmann::json& explanation) {
  const std::vector<nlohmann::json> band = ListAt(explanation, "band_Hz");
  if (band.size() != 2 || !band[0].is_number() || !band[1].is_number()) return "";
  return ShownShort(band[0].get<double>(), 3) + " to " + ShownShort(band[1].get<double>(), 3);
}

std::string RivalsOf(const nlohmann::json& explanation) {
  std::string rivals;
  for (const nlohmann::json& rival : ListAt(explanation, "rivals"))
    rivals += (rivals.empty() ? "" : "; ") + TextAt(rival, "text");
  return rivals;
}

/// "lies near 17.8 Hz (nine tenths of it from 15 to 20 Hz)"; empty where the force is within its noise. Runs of older
/// versions know by its misfit alone that it exceeds that.
std::string WhereSeen(const nlohmann::json& missing) {
  constexpr double kBeyondNoise = 1.5;
  if (!missing.is_object()) return "";
  if (!missing.contains("unexplained") && NumberAt(missing, "misfit") > kBeyondNoise) return "exceeds its noise";
  const nlohmann::json left = missing.value("unexplained", nlohmann::json());
  const double frequency = NumberAt(left, "frequency_Hz");
  if (!std::isfinite(frequency)) return "";
  return "lies near " + ShownShort(frequency, 3) + " Hz (nine tenths of it from " + BandOf(left) + " Hz)";
}

/// What a fit with it would gain by, where the force alone names nothing; empty of runs that did not look or found
/// none.
std::string InsteadByFit(const nlohmann::json& result) {
  const std::vector<nlohmann::json> found = ListAt(result.value("missing", nlohmann::json()), "suggestions");
  if (found.empty()) return "";
  return " A fit with " + html::Escaped(TextAt(found.front(), "text")) + " lowers the cost by " +
         ShownNumber(NumberAt(found.front(), "fall_percent"), 2) +
         " % all the same, see the summary: there the other parameters move with it, here they stay as fitted.";
}

std::string ExplanationTable(const nlohmann::json& missing, const nlohmann::json& result) {
  std::vector<std::vector<html::Cell>> rows;
  for (const nlohmann::json& one : ListAt(missing, "explanations")) {
    const double share = std::abs(NumberAt(one, "sd") / NumberAt(one, "amount"));
    rows.push_back({{html::Escaped(TextAt(one, "text")), "wrap"},
                    html::NumberCell(TextAt(one, "amount_text")),
                    html::NumberCell(ShownNumber(100 * share, 2)),
                    html::NumberCell(BandOf(one)),
                    html::NumberCell(ShownNumber(NumberAt(one, "largest"), 2)),
                    html::NumberCell(ShownNumber(NumberAt(one, "explains_percent"), 2)),
                    {html::Escaped(RivalsOf(one)), "wrap"}});
  }
  if (rows.empty()) {
    const std::string seen = WhereSeen(missing);
    return seen.empty() ? "<p>No mechanism is named: the force is within its noise.</p>\n"
                        : "<p>No mechanism is named: the force " + seen +
                              ", and with the parameters as fitted none of those tried has a tenth of it, at more than "
                              "one frequency. What fitted parameters took up of it no longer shows here." +
                              InsteadByFit(result) + "</p>\n";
  }
  return html::Table(
      {"looks like", "amount", "sd [%]", "band [Hz]", "largest [N]", "explains [%]", "would explain it as well"}, rows);
}

/// Motions without sensors, by recording.
std::string NotMeasuredText(const nlohmann::json& missing) {
  std::string text;
  for (const nlohmann::json& recording : ListAt(missing, "recordings")) {
    std::string motions;
    for (const nlohmann::json& motion : ListAt(recording, "not_measured"))
      if (motion.is_string()) motions += (motions.empty() ? "" : ", ") + html::Escaped(motion.get<std::string>());
    if (!motions.empty())
      text += "<p class=\"note\">" + html::Code(TextAt(recording, "name")) + ": no sensor determines " + motions +
              "; forces that depend on it are left out.</p>\n";
  }
  return text;
}

}  // namespace

std::string MissingForceHtml(const nlohmann::json& result, const std::string* picture) {
  const nlohmann::json missing = result.value("missing_force", nlohmann::json());
  if (!missing.is_object()) return "";
  const bool is_suspected = !ListAt(result.value("audit", nlohmann::json()), "suspicions").empty();
  const double misfit = NumberAt(missing, "misfit");
  std::string html =
      "<p>The motion that the sensors show, put into the fitted equations, leaves a force that the model does not "
      "have. "
      "What it looks like does not depend on the search" +
      std::string(std::isfinite(misfit) ? "; it is " + ShownNumber(misfit, 2) +
                                              " times its noise, with free parameters where they explain most of it"
                                        : "") +
      ".</p>\n";
  if (is_suspected)
    html +=
        "<p><strong>The audit suspects a channel.</strong> A wrong channel makes forces of its own; correct it "
        "first.</p>\n";
  html += ExplanationTable(missing, result);
  if (!ListAt(result.value("missing", nlohmann::json()), "suggestions").empty())
    html +=
        "<p>What could be added to the vehicle, each tried in a fit, is listed in the summary under \u201cWhat is "
        "missing\u201d.</p>\n";
  html += NotMeasuredText(missing);
  if (picture != nullptr)
    html +=
        html::Picture(*picture, "Missing force over frequency, in line with displacement and with speed") +
        "<p class=\"note\">In line with displacement: as a spring has, negative as a mass has. In line with speed: as "
        "a damper has; of a constant size: as dry friction has. missing_force.csv has the numbers.</p>\n";
  return html;
}

std::string MissingForceRemark(const nlohmann::json& result) {
  const std::vector<nlohmann::json> found = ListAt(result.value("missing_force", nlohmann::json()), "explanations");
  if (found.empty()) {
    const std::string seen = WhereSeen(result.value("missing_force", nlohmann::json::object()));
    // What was tried in a fit names it.
    const bool is_named = !ListAt(result.value("missing", nlohmann::json()), "suggestions").empty();
    return seen.empty() || is_named ? ""
                                    : "In the measured motion the equations lack a force that " + seen +
                                          "; no mechanism that was tried has it.";
  }
  const nlohmann::json& first = found.front();
  return "In the measured motion the equations lack a force like " +
         html::Escaped(TextAt(first, "text") + " (" + TextAt(first, "amount_text") + ")") + " from " + BandOf(first) +
         " Hz.";
}

}  // namespace fourpost
