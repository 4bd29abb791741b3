#include "identify/report/modes_page.h"

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/report/vehicle_page.h"

namespace fourpost {
namespace {

CurveGroup ImpulseCurves(const ImpulseFiles& impulse) {
  CurveGroup group{.id = "impulse", .title = "impulse", .x_name = "time", .x_unit = "s", .x = {}, .charts = {}};
  for (Eigen::Index k = 0; k < impulse.channels.front().values.size(); ++k)
    group.x.push_back(static_cast<double>(k) / impulse.rate_Hz);
  for (const HistoryChannel& channel : impulse.channels)
    group.charts.push_back({.title = channel.name,
                            .unit = ShownUnit(channel.unit),
                            .lines = {{channel.name, {channel.values.begin(), channel.values.end()}}}});
  return group;
}

ReportSection InfluenceSection(const ModesAnswer::Influence& influence) {
  const std::string of = " over " + influence.parameter;
  return {"poles-" + influence.parameter, "Poles" + of,
          html::Picture(influence.poles_svg, "Ways of the poles" + of) +
              (influence.responses_svg.empty() ? "" : html::Picture(influence.responses_svg, "Responses" + of))};
}

}  // namespace

std::string ModesPage(const Vehicle& vehicle, const ModesAnswer& answer) {
  VehicleAnswer page{.facts = {"modes"}, .file = answer.file, .findings = answer.findings};
  for (const ModesAnswer::Influence& influence : answer.influences) page.after.push_back(InfluenceSection(influence));
  if (!answer.impulse.channels.empty()) {
    page.curves = {ImpulseCurves(answer.impulse)};
    page.after.push_back({"impulse", "After an impulse",
                          "<p class=\"note\">Readings after an impulse of 1 mm s of all posts, dashpots at their mean "
                          "rates.</p>\n" +
                              CurvesHtml(page.curves.front(), "impulse.csv")});
  }
  return VehiclePage(vehicle, page);
}

}  // namespace fourpost
