#include "identify/report/report_tiles.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"

namespace fourpost {
namespace {

/// Relative standard deviation of a parameter that counts as known.
constexpr double kKnown = 0.1;

std::string Tile(const std::string& title, const std::string& figure, const std::string& note) {
  return "<div class=\"tile\"><span>" + title + "</span><b>" + figure + "</b><span>" + note + "</span></div>\n";
}

std::string CountOf(std::size_t part, std::size_t all) {
  return std::to_string(part) + "<small> of " + std::to_string(all) + "</small>";
}

std::string Capitalised(std::string word) {
  word.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
  return word;
}

std::string Misfit(double misfit) {
  if (!std::isfinite(misfit)) return Tile("Misfit", "\u2013", "not known");
  return Tile("Misfit", ShownNumber(misfit, 2), "times noise and stated model error; 1 is expected");
}

std::string PlaceText(const WorstPlace& place) {
  return "; largest in " + place.recording + " at " + ShownShort(place.lower_Hz, 3) + "\u2013" +
         ShownShort(place.upper_Hz, 3) + " Hz";
}

/// The scripts lead to its chart.
std::string WorstChannel(const JudgedChannel* worst) {
  if (worst == nullptr) return Tile("Worst channel", "\u2013", "nothing was compared");
  const std::string figure = std::isfinite(worst->misfit)
                                 ? ShownNumber(worst->misfit, 2) + " times noise and stated model error"
                                 : worst->numbers;
  return Tile("Worst channel",
              "<a href=\"#" + std::string(worst->is_history ? "histories" : "responses") + "\" data-worst=\"" +
                  html::Escaped(worst->name) + "\">" + html::Code(worst->name) + "</a>",
              html::Escaped(figure + (worst->worst ? PlaceText(*worst->worst) : "")));
}

std::string Predicts(const std::vector<JudgedChannel>& unseen) {
  if (unseen.empty()) return Tile("Predicts", "\u2013", "no recording was kept for validation");
  const auto good = std::count_if(unseen.begin(), unseen.end(),
                                  [](const JudgedChannel& channel) { return channel.follows == Follows::kWell; });
  return Tile("Predicts", CountOf(static_cast<std::size_t>(good), unseen.size()),
              "channels that were not fitted, within tolerance");
}

/// A filled dot for each parameter that is known, a hollow one for each other.
std::string Trust(const std::vector<ReportedParameter>& parameters) {
  const bool is_judged = std::any_of(parameters.begin(), parameters.end(),
                                     [](const ReportedParameter& parameter) { return parameter.IsJudged(); });
  if (!is_judged) return Tile("Parameters", "\u2013", "no intervals");
  std::string dots;
  std::size_t known = 0;
  for (const ReportedParameter& parameter : parameters) {
    const bool is_known = parameter.RelativeSd() <= kKnown && parameter.state != ParameterState::kUndetermined;
    known += is_known;
    dots += "<i class=\"" + std::string(is_known ? "known" : "open") + "\" title=\"" + html::Escaped(parameter.name) +
            "\"></i>";
  }
  return Tile("Parameters", CountOf(known, parameters.size()),
              "known to a tenth <span class=\"dots\">" + dots + "</span>");
}

}  // namespace

std::string TilesHtml(const FitOverview& overview, const std::vector<ReportedParameter>& parameters) {
  return "<div class=\"tiles " + overview.verdict + "\">\n<div class=\"tile\"><span>Fit</span><b class=\"word\">" +
         Capitalised(VerdictWord(overview)) + "</b></div>\n" + Misfit(overview.misfit) +
         WorstChannel(overview.Worst()) + Predicts(overview.unseen) + Trust(parameters) + "</div>\n";
}

}  // namespace fourpost
