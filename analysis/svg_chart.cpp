#include "analysis/svg_chart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/number.h"
#include "analysis/svg_element.h"

namespace fourpost {
namespace {

// Lengths in pixels. Four columns are as wide as GitHub shows a picture.
constexpr double kPanelWidth = 188;
constexpr double kPanelHeight = 116;
constexpr double kColumnPitch = 226;
constexpr double kRowPitch = 164;
constexpr double kLeft = 38;
/// Half of the last tick's label.
constexpr double kRight = 16;
/// From the top of the sheet to that of the first panel, and from the last panel's foot to that of the sheet.
constexpr double kTop = 122;
constexpr double kBottom = 42;
/// Letters are 12 px; of the base line below or above an edge.
constexpr double kLabelBelow = 15;
constexpr double kTitleAbove = 7;
/// Its note may reach over the next panel's uppermost tick.
constexpr double kPanelTitleAbove = 13;

constexpr const char* kShade = "#ececec";

double Across(const SvgPanel& panel, double x) { return kPanelWidth * panel.x.Fraction(x); }
double Down(const SvgPanel& panel, double y) { return kPanelHeight * (1 - panel.y.Fraction(y)); }

std::string Shade(const SvgPanel& panel) {
  const double lower = Across(panel, std::clamp(panel.clear_lower, panel.x.lower, panel.x.upper));
  const double upper = Across(panel, std::clamp(panel.clear_upper, panel.x.lower, panel.x.upper));
  std::string text;
  if (lower > 0) text += svg::Rectangle(0, 0, lower, kPanelHeight, kShade);
  if (upper < kPanelWidth) text += svg::Rectangle(upper, 0, kPanelWidth - upper, kPanelHeight, kShade);
  return text;
}

std::string Grid(const SvgPanel& panel) {
  std::string steps;
  for (const double tick : panel.x.ticks) steps += "M" + svg::Px(Across(panel, tick)) + " 0V" + svg::Px(kPanelHeight);
  for (const double tick : panel.y.ticks) steps += "M0 " + svg::Px(Down(panel, tick)) + "H" + svg::Px(kPanelWidth);
  return svg::Path(steps, svg::kGrid, 1);
}

/// A dot is a line of no length with round ends: a third of the text of a circle.
std::string Marks(const SvgPanel& panel, const SvgSeries& series) {
  std::string steps;
  bool pen_down = false;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double x = Across(panel, series.x[i]);
    const double y = Down(panel, series.y[i]);
    const bool has_place = std::isfinite(x) && std::isfinite(y);
    if (has_place) steps += (pen_down ? "L" : "M") + svg::Px(x) + " " + svg::Px(y);
    if (has_place && series.style.mark == SvgMark::kDots) steps += "h0";
    pen_down = has_place && series.style.mark == SvgMark::kLine;
  }
  return steps;
}

std::string Drawn(const std::string& steps, const SvgStyle& style) {
  return svg::Path(steps, style.color, style.mark == SvgMark::kDots ? 3.2 : 1.4);
}

std::string TickLabels(const SvgPanel& panel, double left, double top) {
  std::string text;
  for (const double tick : panel.x.ticks)
    text += svg::Text(left + Across(panel, tick), top + kPanelHeight + kLabelBelow, "middle", svg::kText,
                      FormatNumber(tick));
  for (const double tick : panel.y.ticks)
    text += svg::Text(left - 5, top + Down(panel, tick) + 4, "end", svg::kText, FormatNumber(tick));
  return text;
}

std::string Panel(const SvgPanel& panel, double left, double top) {
  // A nested document cuts off what leaves it.
  std::string text = "<svg" + svg::Box(left, top, kPanelWidth, kPanelHeight) + ">\n" + Shade(panel) + Grid(panel);
  for (const SvgSeries& series : panel.series) text += Drawn(Marks(panel, series), series.style);
  text += "</svg>\n<rect" + svg::Box(left, top, kPanelWidth, kPanelHeight) + svg::Attribute("fill", "none") +
          svg::Attribute("stroke", svg::kMuted) + "/>\n";
  return text + TickLabels(panel, left, top);
}

std::string Legend(const SvgSheet& sheet, double baseline) {
  constexpr double kSample = 24;
  // Letters are 7 px wide at most.
  const auto pitch = [](const SvgStyle& style) {
    return std::max(120.0, kSample + 24 + 7.0 * static_cast<double>(style.label.size()));
  };
  const double middle = baseline - 4;
  std::string text;
  double x = kLeft;
  for (const SvgStyle& style : sheet.legend) {
    const bool dots = style.mark == SvgMark::kDots;
    std::string steps = "M" + svg::Px(x) + " " + svg::Px(middle) + (dots ? "h0" : "h" + svg::Px(kSample));
    for (double dot = 8; dots && dot <= kSample; dot += 8) steps += "m8 0h0";
    text += Drawn(steps, style) + svg::Text(x + kSample + 8, baseline, "start", svg::kText, style.label);
    x += pitch(style);
  }
  return text;
}

std::string Head(const SvgSheet& sheet) {
  std::string text = svg::Heading(kLeft, 20, sheet.title, "") + Legend(sheet, 42) +
                     svg::Text(kLeft, 62, "start", svg::kMuted, sheet.note);
  for (std::size_t c = 0; c < sheet.columns.size(); ++c)
    text += svg::Text(kLeft + kColumnPitch * static_cast<double>(c) + kPanelWidth / 2, 88, "middle", svg::kText,
                      sheet.columns[c]);
  return text;
}

std::string Row(const SvgRow& row, double top) {
  std::string text = row.title.empty() ? "" : svg::Heading(kLeft, top - kTitleAbove, row.title, row.note);
  for (std::size_t c = 0; c < row.panels.size(); ++c) {
    const SvgPanel& panel = row.panels[c];
    const double left = kLeft + kColumnPitch * static_cast<double>(c);
    if (!panel.title.empty()) text += svg::Heading(left, top - kPanelTitleAbove, panel.title, panel.note);
    text += Panel(panel, left, top);
  }
  return text;
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
  const double columns = static_cast<double>(sheet.columns.size());
  const double rows = static_cast<double>(sheet.rows.size());
  const double width = kLeft + kColumnPitch * (columns - 1) + kPanelWidth + kRight;
  const double height = kTop + kRowPitch * (rows - 1) + kPanelHeight + kBottom;
  std::string text = Head(sheet);
  for (std::size_t r = 0; r < sheet.rows.size(); ++r)
    text += Row(sheet.rows[r], kTop + kRowPitch * static_cast<double>(r));
  for (std::size_t c = 0; c < sheet.columns.size(); ++c) {
    // Below the column's last panel.
    const auto is_short = [c](const SvgRow& row) { return row.panels.size() <= c; };
    const auto missing = std::count_if(sheet.rows.begin(), sheet.rows.end(), is_short);
    text += svg::Text(kLeft + kColumnPitch * static_cast<double>(c) + kPanelWidth / 2,
                      height - 9 - kRowPitch * static_cast<double>(missing), "middle", svg::kText, sheet.x_label);
  }
  return svg::Document(width, height, sheet.title, text);
}

}  // namespace fourpost
