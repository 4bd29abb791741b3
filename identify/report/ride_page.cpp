#include "identify/report/ride_page.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "analysis/comfort/weighting.h"
#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/report/ride_terms.h"
#include "identify/report/sentences_html.h"
#include "identify/report/vehicle_page.h"
#include "vehicles/requests/ride_tables.h"

namespace fourpost {
namespace {

/// "-" and "-1.2", also within a sentence, with a dash and a minus sign.
std::string Typeset(const std::string& text) {
  if (text == "-") return "\u2013";
  std::string typeset;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_minus = text[i] == '-' && (i == 0 || text[i - 1] == ' ') && i + 1 < text.size() &&
                          std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0;
    typeset += is_minus ? "\u2212" : std::string(1, text[i]);
  }
  return typeset;
}

/// With raised powers; that of doses is none that ShownUnit() knows.
std::string HeadOf(const std::string& name) {
  constexpr std::string_view kDose = "m/s^1.75";
  return name.ends_with(kDose) ? name.substr(0, name.size() - kDose.size()) + "m/s\u00b9\u22c5\u2077\u2075"
                               : ShownUnit(name);
}

std::string TableHtml(const RideTable& table) {
  std::vector<std::string> head;
  for (const std::string& name : table.head) head.push_back(HeadOf(name));
  std::vector<std::vector<html::Cell>> rows;
  for (const std::vector<std::string>& row : table.rows) {
    rows.push_back({{html::Code(row.front()), ""}});
    for (std::size_t i = 1; i < row.size(); ++i) rows.back().push_back(html::NumberCell(ShownUnit(Typeset(row[i]))));
  }
  return html::Table(head, rows) + (table.foot.empty() ? "" : SentencesHtml(Typeset(table.foot)));
}

CurveGroup::Chart WeightedChart(const RideAnswer& ride, std::size_t channel, Weighting weighting) {
  const RideSpectra::Channel& felt = ride.spectra.channels[channel];
  return {.title = felt.name,
          .unit = ShownUnit("(m/s^2)^2/Hz"),
          .least = 0,
          .lines = {{"weighted", WeightedDensity(ride.spectra, channel, weighting)}, {"unweighted", felt.density}},
          .is_logarithmic = true,
          // What the sliders compute are power spectra.
          .ride_point = ride.by_spectra ? static_cast<int>(channel) : -1};
}

CurveGroup::Chart WeightingChart(const RideAnswer& ride, Weighting weighting) {
  const WeightingFilter filter(weighting);
  CurveGroup::Line line{"|" + std::string(WeightingName(weighting)) + "|", {}};
  for (const double frequency : ride.spectra.frequency_Hz) line.values.push_back(std::abs(filter.Response(frequency)));
  return {.title = "weighting " + std::string(WeightingName(weighting)),
          .unit = "",
          .least = 0,
          .lines = {std::move(line)}};
}

CurveGroup::Chart LoadChart(const RideAnswer& ride) {
  CurveGroup::Chart chart{
      .title = "tyre loads", .unit = ShownUnit("kN^2/Hz"), .least = 0, .lines = {}, .is_logarithmic = true};
  for (const RideSpectra::Channel& channel : ride.spectra.channels) {
    if (channel.unit != "N") continue;
    chart.lines.push_back({channel.name, channel.density});
    for (double& density : chart.lines.back().values) density *= 1e-6;
  }
  return chart;
}

/// Points first, as SpectraOf() has them.
CurveGroup SpectraOfRide(const ShownRides& shown, std::size_t i) {
  const RideAnswer& ride = shown.rides[i];
  CurveGroup group{.id = "ride_" + std::to_string(i + 1),
                   .title = ride.motion,
                   .x_name = "frequency",
                   .x_unit = "Hz",
                   .x = ride.spectra.frequency_Hz,
                   .x_is_logarithmic = true,
                   .road_class = ride.by_spectra ? ride.road_class : "",
                   .speed = ride.speed,
                   .charts = {}};
  std::vector<Weighting> weightings;
  for (std::size_t c = 0; c < ride.metrics.comfort.size(); ++c) {
    weightings.push_back(ride.metrics.comfort[c].weighting);
    group.charts.push_back(WeightedChart(ride, c, weightings.back()));
  }
  std::sort(weightings.begin(), weightings.end());
  weightings.erase(std::unique(weightings.begin(), weightings.end()), weightings.end());
  for (const Weighting weighting : weightings) group.charts.push_back(WeightingChart(ride, weighting));
  group.charts.push_back(LoadChart(ride));
  return group;
}

ReportSection SectionOf(const ShownRides& shown, std::size_t i, const CurveGroup& spectra) {
  const RideAnswer& ride = shown.rides[i];
  std::string html;
  for (const RideTable& table : RideTables(ride)) html += TableHtml(table);
  std::string title = ride.motion;
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return {"ride-" + std::to_string(i + 1), title,
          html + SentencesHtml(RideMethod(ride) + '\n' + RideFoot(ride)) + RideTermsHtml() +
              "<h3>Power spectra</h3>\n" + (i == 0 ? html::Drawn("sliders") : "") + "<div class=\"follows\"><div>" +
              CurvesHtml(spectra, "spectra.csv") + "</div></div>\n"};
}

}  // namespace

std::string RidePage(const Vehicle& vehicle, const ShownRides& shown) {
  VehicleAnswer page{.facts = {"ride"},
                     .file = shown.file,
                     .ride = shown.first,
                     .findings = shown.findings,
                     .has_sliders_elsewhere = true};
  for (std::size_t i = 0; i < shown.rides.size(); ++i) {
    page.curves.push_back(SpectraOfRide(shown, i));
    page.before.push_back(SectionOf(shown, i, page.curves.back()));
  }
  return VehiclePage(vehicle, page);
}

}  // namespace fourpost
