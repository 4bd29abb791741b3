#include "identify/comparison/methods_chart.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "analysis/charts/svg_chart.h"

namespace fourpost {
namespace {

// Okabe and Ito's, told apart by all eyes.
constexpr std::array<const char*, 7> kColors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                "#E69F00", "#56B4E9", "#000000"};

std::vector<double> SolvedAt(const MethodSummary& method) {
  std::vector<double> evaluations;
  for (const RunOutcome& outcome : method.outcomes)
    if (outcome.solved) evaluations.push_back(static_cast<double>(outcome.evaluations));
  std::sort(evaluations.begin(), evaluations.end());
  return evaluations;
}

/// The most evaluations of any run.
double LastEvaluation(const Comparison& comparison) {
  std::int64_t last = 1;
  for (const MethodSummary& method : comparison.methods)
    for (const RunOutcome& outcome : method.outcomes) last = std::max(last, outcome.evaluations);
  return static_cast<double>(last);
}

/// A step up at each run that solved the problem.
SvgSeries Steps(const MethodSummary& method, const SvgStyle& style, const ChartAxis& axis) {
  const double step = 100 / static_cast<double>(method.outcomes.size());
  SvgSeries series{.style = style, .x = {axis.lower}, .y = {0}};
  for (const double at : SolvedAt(method)) {
    series.x.insert(series.x.end(), {at, at});
    series.y.insert(series.y.end(), {series.y.back(), series.y.back() + step});
  }
  series.x.push_back(axis.upper);
  series.y.push_back(series.y.back());
  return series;
}

}  // namespace

std::string MethodsSvg(const std::string& title, const Comparison& comparison) {
  double first = LastEvaluation(comparison);
  for (const MethodSummary& method : comparison.methods)
    for (const double at : SolvedAt(method)) first = std::min(first, at);
  SvgPanel panel;
  panel.x = LogAxis(0.8 * first, 1.2 * LastEvaluation(comparison));
  panel.y = LinearAxis(0, 100, 5);
  // Lines at either end stand off the frame.
  panel.y.lower = -3;
  panel.y.upper = 103;
  SvgSheet sheet{.title = title,
                 .note = "",
                 .legend = {},
                 .columns = {"share of runs that had solved it, %"},
                 .panel_width = 620,
                 .panel_height = 260,
                 .x_label = "new evaluations",
                 .rows = {}};
  for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
    const SvgStyle style{.label = comparison.methods[i].name, .color = kColors[i % kColors.size()], .width = 2};
    sheet.legend.push_back(style);
    panel.series.push_back(Steps(comparison.methods[i], style, panel.x));
  }
  sheet.rows = {{.title = "", .note = "", .panels = {panel}}};
  return SvgText(sheet);
}

}  // namespace fourpost
