#include "analysis/charts/svg_chart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/charts/svg_element.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

// Lengths in pixels.
/// Room for labels of four letters.
constexpr double kLeftMargin = 38;
constexpr double kRightMargin = 16;
constexpr double kBetweenRows = 48;
/// Letters are this wide at most.
constexpr double kLetter = 7;
/// From the top of the sheet to the heads of the columns, from there to the first panel, less a line where nothing
/// stands in it; and from the last panel's foot to that of the sheet.
constexpr double kColumnsBaseline = 88;
constexpr double kBelowColumns = 34;
constexpr double kLine = 20;
constexpr double kBottomMargin = 42;
/// Letters are 12 px; of the base line below or above an edge.
constexpr double kLabelBelow = 15;
constexpr double kTitleAbove = 7;
/// Its note may reach over the next panel's uppermost tick.
constexpr double kPanelTitleAbove = 13;

constexpr const char* kShade = "#ececec";

/// Where things are on a sheet.
struct Layout {
  double panel_width = 0;
  double panel_height = 0;
  /// Of the first column.
  double left = kLeftMargin;
  double column_pitch = 0;
  double row_pitch = 0;
  double width = 0;
  double columns_baseline = 0;
  /// Of the first panel.
  double top = 0;

  double Across(const SvgPanel& panel, double x) const { return panel_width * panel.x.Fraction(x); }
  double Down(const SvgPanel& panel, double y) const { return panel_height * (1 - panel.y.Fraction(y)); }
  double ColumnAt(std::size_t c) const { return left + column_pitch * static_cast<double>(c); }
};

double WidthOf(const std::string& text) { return kLetter * static_cast<double>(text.size()); }

std::string Shade(const SvgPanel& panel, const Layout& layout) {
  const double lower = layout.Across(panel, std::clamp(panel.clear_lower, panel.x.lower, panel.x.upper));
  const double upper = layout.Across(panel, std::clamp(panel.clear_upper, panel.x.lower, panel.x.upper));
  std::string text;
  if (lower > 0) text += svg::Rectangle(0, 0, lower, layout.panel_height, kShade);
  if (upper < layout.panel_width)
    text += svg::Rectangle(upper, 0, layout.panel_width - upper, layout.panel_height, kShade);
  return text;
}

std::string Grid(const SvgPanel& panel, const Layout& layout) {
  std::string steps;
  for (const double tick : panel.x.ticks)
    steps += "M" + svg::Px(layout.Across(panel, tick)) + " 0V" + svg::Px(layout.panel_height);
  for (const double tick : panel.y.ticks)
    steps += "M0 " + svg::Px(layout.Down(panel, tick)) + "H" + svg::Px(layout.panel_width);
  return svg::Path(steps, svg::kGrid, 1);
}

/// A dot is a line of no length with round ends: a third of the text of a circle.
std::string Marks(const SvgPanel& panel, const SvgSeries& series, const Layout& layout) {
  std::string steps;
  bool pen_down = false;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double x = layout.Across(panel, series.x[i]);
    const double y = layout.Down(panel, series.y[i]);
    const bool has_place = std::isfinite(x) && std::isfinite(y);
    if (has_place) steps += (pen_down ? "L" : "M") + svg::Px(x) + " " + svg::Px(y);
    if (has_place && series.style.mark == SvgMark::kDots) steps += "h0";
    pen_down = has_place && series.style.mark == SvgMark::kLine;
  }
  return steps;
}

std::string Drawn(const std::string& steps, const SvgStyle& style) {
  const double usual = style.mark == SvgMark::kDots ? 3.2 : 1.4;
  return svg::Path(steps, style.color, style.width > 0 ? style.width : usual);
}

std::string TickLabels(const SvgPanel& panel, double left, double top, const Layout& layout) {
  std::string text;
  for (const double tick : panel.x.ticks)
    text += svg::Text(left + layout.Across(panel, tick), top + layout.panel_height + kLabelBelow, "middle", svg::kText,
                      FormatNumber(tick));
  for (const double tick : panel.y.ticks)
    text += svg::Text(left - 5, top + layout.Down(panel, tick) + 4, "end", svg::kText, FormatNumber(tick));
  return text;
}

std::string Panel(const SvgPanel& panel, double left, double top, const Layout& layout) {
  // A nested document cuts off what leaves it.
  std::string text = "<svg" + svg::Box(left, top, layout.panel_width, layout.panel_height) + ">\n" +
                     Shade(panel, layout) + Grid(panel, layout);
  for (const SvgSeries& series : panel.series) text += Drawn(Marks(panel, series, layout), series.style);
  text += "</svg>\n<rect" + svg::Box(left, top, layout.panel_width, layout.panel_height) +
          svg::Attribute("fill", "none") + svg::Attribute("stroke", svg::kMuted) + "/>\n";
  return text + TickLabels(panel, left, top, layout);
}

constexpr double kSample = 24;

double LegendPitch(const SvgStyle& style) { return std::max(120.0, kSample + 24 + WidthOf(style.label)); }

std::string Legend(const SvgSheet& sheet, const Layout& layout, double baseline) {
  const double middle = baseline - 4;
  std::string text;
  double x = layout.left;
  for (const SvgStyle& style : sheet.legend) {
    const bool dots = style.mark == SvgMark::kDots;
    std::string steps = "M" + svg::Px(x) + " " + svg::Px(middle) + (dots ? "h0" : "h" + svg::Px(kSample));
    for (double dot = 8; dots && dot <= kSample; dot += 8) steps += "m8 0h0";
    text += Drawn(steps, style) + svg::Text(x + kSample + 8, baseline, "start", svg::kText, style.label);
    x += LegendPitch(style);
  }
  return text;
}

std::string Head(const SvgSheet& sheet, const Layout& layout) {
  std::string text = svg::Heading(layout.left, 20, sheet.title, "") + Legend(sheet, layout, 42) +
                     svg::Text(layout.left, 62, "start", svg::kMuted, sheet.note);
  for (std::size_t c = 0; c < sheet.columns.size(); ++c)
    text += svg::Text(layout.ColumnAt(c) + layout.panel_width / 2, layout.columns_baseline, "middle", svg::kText,
                      sheet.columns[c]);
  return text;
}

std::string Row(const SvgRow& row, double top, const Layout& layout) {
  std::string text = row.title.empty() ? "" : svg::Heading(layout.left, top - kTitleAbove, row.title, row.note);
  for (std::size_t c = 0; c < row.panels.size(); ++c) {
    const SvgPanel& panel = row.panels[c];
    if (!panel.title.empty()) text += svg::Heading(layout.ColumnAt(c), top - kPanelTitleAbove, panel.title, panel.note);
    text += Panel(panel, layout.ColumnAt(c), top, layout);
  }
  return text;
}

/// How far labels of the horizontal axis reach over a panel's right edge.
double Overhang(const SvgPanel& panel, double panel_width) {
  double overhang = 0;
  for (const double tick : panel.x.ticks)
    overhang = std::max(overhang, panel_width * (panel.x.Fraction(tick) - 1) + WidthOf(FormatNumber(tick)) / 2);
  return overhang;
}

Layout LayoutOf(const SvgSheet& sheet) {
  constexpr double kGap = 10;
  double before = kLeftMargin;
  double after = kRightMargin;
  for (const SvgRow& row : sheet.rows)
    for (const SvgPanel& panel : row.panels) {
      for (const double tick : panel.y.ticks) before = std::max(before, kGap + WidthOf(FormatNumber(tick)));
      after = std::max(after, 2 + Overhang(panel, sheet.panel_width));
    }
  Layout layout{.panel_width = sheet.panel_width, .panel_height = sheet.panel_height, .left = before};
  layout.column_pitch = sheet.panel_width + before;
  layout.row_pitch = sheet.panel_height + kBetweenRows;
  layout.columns_baseline = kColumnsBaseline - (sheet.note.empty() ? kLine : 0);
  const bool has_titles = std::any_of(sheet.rows.begin(), sheet.rows.end(), [](const SvgRow& row) {
    return !row.title.empty() || std::any_of(row.panels.begin(), row.panels.end(),
                                             [](const SvgPanel& panel) { return !panel.title.empty(); });
  });
  layout.top = layout.columns_baseline + kBelowColumns - (has_titles ? 0 : kLine);
  double legend = 0;
  for (const SvgStyle& style : sheet.legend) legend += LegendPitch(style);
  const double panels = layout.column_pitch * static_cast<double>(sheet.columns.size() - 1) + sheet.panel_width;
  layout.width = before + std::max({panels + after, legend, WidthOf(sheet.note)});
  return layout;
}

void Check(const SvgSheet& sheet) {
  if (sheet.columns.empty()) throw std::invalid_argument("a sheet needs a column");
  for (const SvgRow& row : sheet.rows) {
    if (row.panels.size() > sheet.columns.size())
      throw std::invalid_argument("row '" + row.title + "' has more panels than there are columns");
    for (const SvgPanel& panel : row.panels) {
      panel.x.Validate();
      panel.y.Validate();
      for (const SvgSeries& series : panel.series)
        if (series.x.size() != series.y.size())
          throw std::invalid_argument("series '" + series.style.label + "' needs one y per x");
    }
  }
}

}  // namespace

std::string SvgText(const SvgSheet& sheet) {
  Check(sheet);
  const Layout layout = LayoutOf(sheet);
  const double rows = static_cast<double>(sheet.rows.size());
  const double height = layout.top + layout.row_pitch * (rows - 1) + layout.panel_height + kBottomMargin;
  std::string text = Head(sheet, layout);
  for (std::size_t r = 0; r < sheet.rows.size(); ++r)
    text += Row(sheet.rows[r], layout.top + layout.row_pitch * static_cast<double>(r), layout);
  for (std::size_t c = 0; c < sheet.columns.size(); ++c) {
    // Below the column's last panel.
    const auto is_short = [c](const SvgRow& row) { return row.panels.size() <= c; };
    const auto missing = std::count_if(sheet.rows.begin(), sheet.rows.end(), is_short);
    text +=
        svg::Text(layout.ColumnAt(c) + layout.panel_width / 2,
                  height - 9 - layout.row_pitch * static_cast<double>(missing), "middle", svg::kText, sheet.x_label);
  }
  return svg::Document(layout.width, height, sheet.title, text);
}

}  // namespace fourpost
