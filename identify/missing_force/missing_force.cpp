#include "identify/missing_force/missing_force.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "analysis/charts/bode_panel.h"
#include "analysis/charts/svg_chart.h"
#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "analysis/text/short_number.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;
using Kind = ForceMechanism::Kind;

std::string SiUnitOf(Kind kind) {
  switch (kind) {
    case Kind::kSpring: return "N/m";
    case Kind::kDamper: return "N*s/m";
    case Kind::kFriction: return "N";
    case Kind::kAddedMass:
    case Kind::kPartOnMounts: return "kg";
  }
  return "";
}

/// "149 N", "12.3 N/mm"
std::string AmountText(Kind kind, double amount) {
  if (kind == Kind::kSpring) return ShortNumber(1e-3 * amount, 3) + " N/mm";
  return ShortNumber(amount, 3) + ' ' + (kind == Kind::kDamper ? "N s/m" : SiUnitOf(kind));
}

/// "friction in damper 'front'", "a part of mass on mounts at 8.5 Hz, on link 'chassis'"
std::string WordsOf(const ForceMechanism& mechanism, const ForceRecord& record) {
  const std::string place = PlaceName(mechanism, record);
  switch (mechanism.kind) {
    case Kind::kSpring: return "more stiffness along " + place;
    case Kind::kDamper: return "more damping along " + place;
    case Kind::kFriction: return "dry friction along " + place;
    case Kind::kAddedMass: return "more mass on " + place;
    case Kind::kPartOnMounts:
      return "a part on mounts at " + ShortNumber(mechanism.frequency_Hz, 3) + " Hz, on " + place;
  }
  return "";
}

Json RivalsJson(const ForceExplanation& one, const ForceRecord& record) {
  constexpr std::size_t kMost = 3;
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(kMost, one.rivals.size()); ++i)
    list.push_back({{"mechanism", MechanismName(one.rivals[i].kind)},
                    {"elements", ElementNames(one.rivals[i], record)},
                    {"text", WordsOf(one.rivals[i], record)}});
  return list;
}

Json ExplanationJson(const ForceExplanation& one, const ForceRecord& record) {
  const ForceMechanism& mechanism = one.mechanism;
  const bool has_shape = mechanism.kind == Kind::kPartOnMounts;
  return {{"mechanism", MechanismName(mechanism.kind)},
          {"elements", ElementNames(mechanism, record)},
          {"text", WordsOf(mechanism, record)},
          {"amount", one.amount},
          {"sd", one.sd},
          {"unit", SiUnitOf(mechanism.kind)},
          {"amount_text", AmountText(mechanism.kind, one.amount)},
          {"frequency_Hz", has_shape ? Json(mechanism.frequency_Hz) : Json(nullptr)},
          {"damping_ratio", has_shape ? Json(mechanism.damping_ratio) : Json(nullptr)},
          {"place_m", has_shape ? Json(mechanism.place_m) : Json(nullptr)},
          {"band_Hz", {one.lower_Hz, one.upper_Hz}},
          {"largest", one.most_N},
          {"explains_percent", 100 * one.share},
          {"standard_deviations", std::sqrt(one.score)},
          {"rivals", RivalsJson(one, record)}};
}

Json LeftJson(const std::optional<UnexplainedForce>& left) {
  if (!left) return nullptr;
  return {{"frequency_Hz", left->frequency_Hz}, {"band_Hz", {left->lower_Hz, left->upper_Hz}}};
}

std::string UnitOf(const ForceCurve& curve) { return curve.is_turn ? "N*m" : "N"; }

SvgStyle WithDisplacement() { return {.label = "in line with displacement", .color = "#0072B2"}; }
SvgStyle WithSpeed() { return {.label = "in line with speed", .color = "#D55E00"}; }
SvgStyle Noise() { return {.label = "2 sd of noise", .color = "#999999", .width = 1}; }

bool HasForce(const ForceCurve& curve) {
  return std::any_of(curve.force_sd.begin(), curve.force_sd.end(), [](double sd) { return std::isfinite(sd); });
}

SvgPanel PanelOf(const ForceCurve& curve) {
  SvgSeries displacement{.style = WithDisplacement(), .x = curve.frequency_Hz, .y = {}};
  SvgSeries speed{.style = WithSpeed(), .x = curve.frequency_Hz, .y = {}};
  SvgSeries above{.style = Noise(), .x = curve.frequency_Hz, .y = {}};
  SvgSeries below = above;
  for (std::size_t i = 0; i < curve.force.size(); ++i) {
    const ForceParts parts = PartsOf(curve, i);
    displacement.y.push_back(parts.with_displacement);
    speed.y.push_back(parts.with_speed);
    above.y.push_back(2 * curve.force_sd[i]);
    below.y.push_back(-2 * curve.force_sd[i]);
  }
  return {.series = {above, below, displacement, speed}};
}

/// Over all panels of a row.
double LargestOf(const std::vector<SvgPanel>& panels) {
  double largest = 0;
  for (const SvgPanel& panel : panels)
    for (const SvgSeries& series : panel.series)
      for (const double value : series.y)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest > 0 ? largest : 1;
}

}  // namespace

Json MissingForceJson(const ForceRecord& record, const ForceExplanations& explanations) {
  Json recordings = Json::array();
  for (std::size_t run = 0; run < record.runs.size(); ++run)
    recordings.push_back({{"name", record.runs[run]},
                          {"frequencies", std::count_if(record.samples.begin(), record.samples.end(),
                                                        [&](const ForceSample& one) { return one.run == run; })},
                          {"not_measured", record.not_measured[run]}});
  Json list = Json::array();
  for (const ForceExplanation& one : explanations.found) list.push_back(ExplanationJson(one, record));
  return {{"recordings", recordings},
          {"lines_are_unique", AreLinesUnique(record)},
          {"misfit", NumberOrNull(explanations.misfit)},
          {"explanations", list},
          {"unexplained", LeftJson(explanations.left)}};
}

std::string MissingForceCsv(const ForceRecord& record, const std::vector<ForceCurve>& curves) {
  CsvWriter csv({"recording", "kind", "of", "unit", "frequency_Hz", "force", "force_sd", "with_displacement",
                 "with_speed", "motion", "stiffness", "damping", "friction", "mass"});
  for (const ForceCurve& curve : curves)
    for (std::size_t i = 0; i < curve.force.size(); ++i) {
      const ForceParts parts = PartsOf(curve, i);
      csv.Add(record.runs[curve.run]).Add(curve.is_line ? "line" : "coordinate").Add(curve.of).Add(UnitOf(curve));
      csv.Add(curve.frequency_Hz[i]).Add(std::abs(curve.force[i])).Add(curve.force_sd[i]);
      csv.Add(parts.with_displacement).Add(parts.with_speed).Add(std::abs(curve.motion[i]));
      csv.Add(parts.stiffness).Add(parts.damping).Add(parts.friction).Add(parts.mass);
    }
  return csv.text();
}

std::string MissingForceSvg(const ForceRecord& record, const std::vector<ForceCurve>& curves) {
  const bool by_line = AreLinesUnique(record);
  std::vector<std::string> order;
  double lowest = 0;
  double highest = 0;
  for (const ForceCurve& curve : curves) {
    if (curve.is_line != by_line || !HasForce(curve)) continue;
    if (std::find(order.begin(), order.end(), curve.of) == order.end()) order.push_back(curve.of);
    const auto [least, most] = std::minmax_element(curve.frequency_Hz.begin(), curve.frequency_Hz.end());
    lowest = lowest > 0 ? std::min(lowest, *least) : *least;
    highest = std::max(highest, *most);
  }
  if (order.empty() || !(highest > lowest)) return "";
  SvgSheet sheet{.title = "Force that the fitted equations lack in the measured motion",
                 .note = by_line ? "as a tension along each line" : "as a force on each coordinate",
                 .legend = {WithDisplacement(), WithSpeed(), Noise()},
                 .x_label = "frequency [Hz]"};
  sheet.panel_width = 280;
  for (const std::string& run : record.runs) sheet.columns.push_back(run);
  for (const std::string& of : order) {
    SvgRow row{.title = of};
    row.panels.resize(record.runs.size());
    for (const ForceCurve& curve : curves)
      if (curve.of == of && curve.is_line == by_line) {
        row.panels[curve.run] = PanelOf(curve);
        row.note = curve.is_turn ? "moment [N m]" : "force [N]";
      }
    const double largest = LargestOf(row.panels);
    for (SvgPanel& panel : row.panels) {
      panel.x = FrequencyAxis(lowest, highest);
      panel.y = LinearAxis(-largest, largest, 4);
    }
    sheet.rows.push_back(std::move(row));
  }
  return SvgText(sheet);
}

std::string MissingForceText(const Json& json) {
  std::string text;
  for (const auto& one : json["explanations"])
    text += "  " + one["text"].get<std::string>() + ", " + one["amount_text"].get<std::string>() + ": explains " +
            ShortNumber(one["explains_percent"], 2) + " % of it, " + ShortNumber(one["band_Hz"][0], 3) + " to " +
            ShortNumber(one["band_Hz"][1], 3) + " Hz\n";
  return text.empty() ? "" : "The force that the equations lack in the measured motion is that of\n" + text;
}

}  // namespace fourpost
