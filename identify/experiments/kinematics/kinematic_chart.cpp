#include "identify/experiments/kinematics/kinematic_chart.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "analysis/charts/svg_chart.h"

namespace fourpost {
namespace {

constexpr std::size_t kColumns = 3;
/// Of the curves of a panel, distinct without red and green too.
constexpr std::array<const char*, 4> kColors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7"};

double SizeOf(std::string_view unit) { return unit.empty() ? 1 : ParseUnit(unit)->si; }

/// By rising position.
SvgSeries SeriesOf(const KinematicMisfit& one, const SvgStyle& style, bool is_measured) {
  const KinematicCurve& curve = *one.curve;
  std::vector<std::size_t> order(curve.places.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return curve.places[a] < curve.places[b]; });
  SvgSeries series{.style = style, .x = {}, .y = {}};
  for (const std::size_t i : order) {
    const double value = is_measured ? curve.measured[i] : one.modelled[static_cast<Eigen::Index>(i)] + one.offset;
    series.x.push_back(one.sweep->positions[curve.places[i]] / SizeOf(one.sweep->position_unit()));
    series.y.push_back(value / SizeOf(curve.quantity->unit));
  }
  return series;
}

ChartAxis AxisOf(const std::vector<SvgSeries>& all, std::vector<double> SvgSeries::*values, double least, int parts) {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  for (const SvgSeries& series : all)
    for (const double value : series.*values) {
      lower = std::min(lower, value);
      upper = std::max(upper, value);
    }
  const double margin = std::max(0.02 * (upper - lower), 0.5 * (least - (upper - lower)));
  return LinearAxis(lower - margin, upper + margin, parts);
}

/// Curves of one quantity in one sweep, which follow one another.
SvgPanel PanelOf(std::span<const KinematicMisfit> curves) {
  const KinematicQuantity& quantity = *curves.front().curve->quantity;
  SvgPanel panel;
  const KinematicSweep& sweep = *curves.front().sweep;
  panel.title = sweep.recording + ", " + sweep.motion + ": " + std::string(quantity.name) +
                (quantity.unit.empty() ? "" : " [" + std::string(quantity.unit) + "]");
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const char* const color = kColors[i % kColors.size()];
    panel.series.push_back(SeriesOf(curves[i], {.label = "", .color = color, .mark = SvgMark::kLine}, false));
    panel.series.push_back(SeriesOf(curves[i], {.label = "", .color = color, .mark = SvgMark::kDots}, true));
  }
  // Noise of what does not change is no picture.
  const double least = 6 * curves.front().curve->sd / SizeOf(quantity.unit);
  panel.x = AxisOf(panel.series, &SvgSeries::x, 1e-6, 5);
  panel.y = AxisOf(panel.series, &SvgSeries::y, least, 5);
  return panel;
}

}  // namespace

std::string KinematicSvg(const std::string& title, std::span<const KinematicMisfit> misfits) {
  SvgSheet sheet{.title = title,
                 .note = "dots: measured, lines: the vehicle; by wheel or strut: blue the first, orange the second",
                 .legend = {},
                 .columns = std::vector<std::string>(kColumns),
                 .panel_width = 250,
                 .panel_height = 150,
                 .x_label = "travel [mm], or load [N, N m]",
                 .rows = {}};
  const KinematicSweep* sweep = nullptr;
  for (std::size_t i = 0; i < misfits.size();) {
    std::size_t end = i;
    while (end < misfits.size() && misfits[end].sweep == misfits[i].sweep &&
           misfits[end].curve->quantity == misfits[i].curve->quantity)
      ++end;
    if (misfits[i].sweep != sweep || sheet.rows.back().panels.size() == kColumns) sheet.rows.emplace_back();
    sweep = misfits[i].sweep;
    sheet.rows.back().panels.push_back(PanelOf(misfits.subspan(i, end - i)));
    i = end;
  }
  return SvgText(sheet);
}

}  // namespace fourpost
