#include "identify/choice/choice_charts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/charts/heat_chart.h"
#include "analysis/charts/svg_chart.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

/// Colours of Okabe and Ito.
constexpr const char* kAllColor = "#b8b8b8";
constexpr const char* kFrontColor = "#0072B2";
constexpr const char* kIndistinctColor = "#E69F00";
constexpr const char* kBestColor = "#D55E00";
constexpr const char* kPresentColor = "#222222";

std::string ObjectivesTogether(const ChoiceAnswer& answer) {
  std::string text;
  for (const Objective& objective : answer.request.settings.objectives)
    text += (text.empty() ? "" : " and ") + answer.MetricOf(objective).name;
  return text;
}

/// Rated settings about the best one.
class SettingMap {
 public:
  explicit SettingMap(const ChoiceAnswer& answer)
      : answer_(answer), best_(answer.choice.rows[*answer.choice.best].setting) {
    for (std::size_t s = 0; s < answer.choice.rows.size(); ++s) places_.emplace(answer.choice.rows[s].setting, s);
  }

  /// The row at these positions of two knobs, the others at the best ones.
  const RatedSetting* At(std::size_t x_knob, int x, std::size_t y_knob, int y) const {
    Setting setting = best_;
    setting[x_knob] = x;
    setting[y_knob] = y;
    const auto place = places_.find(setting);
    return place == places_.end() ? nullptr : &answer_.choice.rows[place->second];
  }

  /// Range of the change along a knob.
  double RangeOf(std::size_t knob) const {
    double least = 0;
    double most = 0;
    for (int p = 0; p < static_cast<int>(answer_.knobs()[knob].positions.size()); ++p) {
      const RatedSetting* row = At(knob, p, knob, p);
      if (row == nullptr || !row->failure.empty()) continue;
      const double change = row->change.mean - answer_.choice.rows[*answer_.choice.best].change.mean;
      least = std::min(least, change);
      most = std::max(most, change);
    }
    return most - least;
  }

  /// Whether two knobs span the plane on which this setting lies.
  bool Holds(const Setting& setting, std::size_t x_knob, std::size_t y_knob) const {
    for (std::size_t k = 0; k < setting.size(); ++k)
      if ((k != x_knob && k != y_knob && setting[k] != best_[k]) || setting[k] == kAsFitted) return false;
    return true;
  }

 private:
  const ChoiceAnswer& answer_;
  const Setting& best_;
  std::map<Setting, std::size_t> places_;
};

std::vector<std::string> PositionNames(const Knob& knob) {
  std::vector<std::string> names;
  for (const Knob::Position& position : knob.positions) names.push_back(position.name);
  return names;
}

std::optional<HeatChart::Mark> MarkOf(const ChoiceAnswer& answer, const SettingMap& map, std::size_t row, std::size_t x,
                                      std::size_t y, const std::string& label) {
  const Setting& setting = answer.choice.rows[row].setting;
  if (!map.Holds(setting, x, y)) return std::nullopt;
  return HeatChart::Mark{label, {static_cast<std::size_t>(setting[x]), static_cast<std::size_t>(setting[y])}};
}

SvgSeries Dots(const ChoiceAnswer& answer, const SvgStyle& style, const std::vector<std::size_t>& rows) {
  SvgSeries series{.style = style, .x = {}, .y = {}};
  for (const std::size_t row : rows) {
    series.x.push_back(100 * answer.choice.rows[row].changes[0].mean);
    series.y.push_back(100 * answer.choice.rows[row].changes[1].mean);
  }
  return series;
}

/// About these shares, at least a thousandth wide.
ChartAxis PercentAxis(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double margin = std::max(0.04 * (*most - *least), 0.05);
  return LinearAxis(*least - margin, *most + margin, 8);
}

SvgSeries RootSeries(const RideSpectra& spectra, std::size_t channel, const SvgStyle& style) {
  SvgSeries series{.style = style, .x = spectra.frequency_Hz, .y = {}};
  for (const double density : spectra.channels[channel].density) series.y.push_back(std::sqrt(density));
  return series;
}

}  // namespace

std::string SettingsSvg(const ChoiceAnswer& answer) {
  const std::vector<Knob>& knobs = answer.knobs();
  if (!answer.choice.best || knobs.size() < 2) return "";
  const SettingMap map(answer);
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < knobs.size(); ++k) order.push_back(k);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return map.RangeOf(a) > map.RangeOf(b); });
  const std::size_t x = std::min(order[0], order[1]);
  const std::size_t y = std::max(order[0], order[1]);
  HeatChart chart{.title = "Settings of " + knobs[x].name + " and " + knobs[y].name,
                  .note = knobs.size() > 2 ? "the other knobs as in the best setting" : "",
                  .x_label = knobs[x].name,
                  .y_label = knobs[y].name,
                  .columns = PositionNames(knobs[x]),
                  .rows = PositionNames(knobs[y]),
                  .cells = {},
                  .value_label = ObjectivesTogether(answer) + ", %",
                  .framed_label = !answer.has_doubt() ? "" : "not to be distinguished from the best",
                  .barred_label = answer.request.settings.limits.empty() ? "" : "beyond a limit",
                  .ring = MarkOf(answer, map, *answer.choice.best, x, y, "best"),
                  .cross = MarkOf(answer, map, answer.choice.present, x, y, "now")};
  for (int r = 0; r < static_cast<int>(knobs[y].positions.size()); ++r) {
    chart.cells.emplace_back();
    for (int c = 0; c < static_cast<int>(knobs[x].positions.size()); ++c) {
      const RatedSetting* row = map.At(x, c, y, r);
      const bool has_answer = row != nullptr && row->failure.empty();
      chart.cells.back().push_back({.value = has_answer ? 100 * row->change.mean : std::nan(""),
                                    .is_barred = has_answer && !row->is_admitted,
                                    .is_framed = has_answer && row->is_indistinct && answer.has_doubt()});
    }
  }
  return HeatSvg(chart);
}

std::string FrontSvg(const ChoiceAnswer& answer) {
  const Choice& choice = answer.choice;
  if (!choice.best || answer.request.settings.objectives.size() != 2) return "";
  std::vector<std::size_t> admitted;
  std::vector<std::size_t> indistinct;
  for (std::size_t s = 0; s < choice.rows.size(); ++s) {
    if (choice.rows[s].is_admitted || (s == choice.present && choice.rows[s].failure.empty())) admitted.push_back(s);
    if (choice.rows[s].is_indistinct) indistinct.push_back(s);
  }
  const SvgSeries all = Dots(answer, {"setting", kAllColor, SvgMark::kDots, 4}, admitted);
  std::vector<SvgSeries> series = {all, Dots(answer, {"front", kFrontColor, SvgMark::kLine, 1.6}, choice.front)};
  series.push_back(Dots(answer, {"front", kFrontColor, SvgMark::kDots, 5}, choice.front));
  if (answer.has_doubt())
    series.push_back(Dots(answer, {"not distinguished", kIndistinctColor, SvgMark::kDots, 6}, indistinct));
  series.push_back(Dots(answer, {"now", kPresentColor, SvgMark::kDots, 8}, {choice.present}));
  series.push_back(Dots(answer, {"best together", kBestColor, SvgMark::kDots, 8}, {*choice.best}));
  SvgSheet sheet{.title = "Two objectives, change against now",
                 .note = "",
                 .legend = {},
                 .columns = {""},
                 .panel_width = 560,
                 .panel_height = 360,
                 .x_label = answer.MetricOf(answer.request.settings.objectives[0]).name + ", %",
                 .rows = {}};
  for (const SvgSeries& one : series)
    if (one.style.label != "front" || one.style.mark == SvgMark::kLine) sheet.legend.push_back(one.style);
  SvgPanel panel{.title = answer.MetricOf(answer.request.settings.objectives[1]).name + ", %",
                 .note = "",
                 .x = PercentAxis(all.x),
                 .y = PercentAxis(all.y),
                 .series = series};
  sheet.rows.push_back({"", "", {panel}});
  return SvgText(sheet);
}

std::string SpectraSvg(const ChoiceAnswer& answer) {
  if (answer.best_spectra.channels.empty() || answer.choice.best == answer.choice.present) return "";
  const SvgStyle now = {"now, " + answer.NameOf(answer.choice.present), kPresentColor, SvgMark::kLine, 1.4};
  const SvgStyle best = {"best, " + answer.NameOf(*answer.choice.best), kBestColor, SvgMark::kLine, 1.4};
  const std::vector<double>& frequency = answer.best_spectra.frequency_Hz;
  SvgSheet sheet{.title = "Accelerations and tyre loads",
                 .note = "root power spectral density over frequency [Hz], on the road with the largest weight",
                 .legend = {now, best},
                 .columns = {"", "", "", ""},
                 .x_label = "Hz",
                 .rows = {}};
  for (std::size_t c = 0; c < answer.best_spectra.channels.size(); ++c) {
    SvgPanel panel{.title = answer.best_spectra.channels[c].name,
                   .note = answer.best_spectra.channels[c].unit + "/√Hz",
                   .x = LogAxis(frequency.front(), frequency.back()),
                   .y = {},
                   .series = {RootSeries(answer.present_spectra, c, now), RootSeries(answer.best_spectra, c, best)}};
    double most = 0;
    for (const SvgSeries& series : panel.series)
      for (const double y : series.y) most = std::max(most, y);
    panel.y = LinearAxis(0, most > 0 ? most : 1, 4);
    if (c % sheet.columns.size() == 0) sheet.rows.push_back({"", "", {}});
    sheet.rows.back().panels.push_back(std::move(panel));
  }
  return SvgText(sheet);
}

}  // namespace fourpost
