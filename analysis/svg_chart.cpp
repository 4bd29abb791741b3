#include "analysis/svg_chart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/number.h"

namespace fourpost {
namespace {

// Lengths in pixels. Four columns are as wide as GitHub shows a picture.
constexpr double kPanelWidth = 188;
constexpr double kPanelHeight = 116;
constexpr double kColumnPitch = 226;
constexpr double kRowPitch = 164;
constexpr double kLeft = 38;
constexpr double kRight = 10;
/// From the top of the sheet to that of the first panel, and from the last panel's foot to that of the sheet.
constexpr double kTop = 122;
constexpr double kBottom = 42;
/// Letters are 12 px; of the base line below or above an edge.
constexpr double kLabelBelow = 15;
constexpr double kTitleAbove = 7;

constexpr const char* kText = "#222";
constexpr const char* kMuted = "#666";
constexpr const char* kGrid = "#d4d4d4";
constexpr const char* kShade = "#ececec";

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') escaped += "&amp;";
    else if (c == '<') escaped += "&lt;";
    else if (c == '>') escaped += "&gt;";
    else if (c == '"') escaped += "&quot;";
    else
      // Most control characters have no place in XML.
      escaped += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return escaped;
}

/// A length to a tenth of a pixel.
std::string Px(double length) {
  // No "-0".
  return FormatNumber(std::round(length * 10) / 10 + 0.0);
}

std::string Attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + Escaped(value) + '"';
}

std::string Box(double x, double y, double width, double height) {
  return Attribute("x", Px(x)) + Attribute("y", Px(y)) + Attribute("width", Px(width)) +
         Attribute("height", Px(height));
}

std::string Rectangle(double x, double y, double width, double height, const char* fill) {
  return "<rect" + Box(x, y, width, height) + Attribute("fill", fill) + "/>\n";
}

std::string Path(const std::string& steps, const std::string& color, double width) {
  return "<path" + Attribute("d", steps) + Attribute("fill", "none") + Attribute("stroke", color) +
         Attribute("stroke-width", Px(width)) + Attribute("stroke-linecap", "round") +
         Attribute("stroke-linejoin", "round") + "/>\n";
}

/// `anchor`: start, middle or end of the text is at x.
std::string Text(double x, double y, const char* anchor, const char* color, const std::string& text) {
  return "<text" + Attribute("x", Px(x)) + Attribute("y", Px(y)) + Attribute("text-anchor", anchor) +
         Attribute("fill", color) + ">" + Escaped(text) + "</text>\n";
}

/// A bold title and, after it, a note.
std::string Heading(double x, double y, const std::string& title, const std::string& note) {
  return "<text" + Attribute("x", Px(x)) + Attribute("y", Px(y)) + Attribute("fill", kText) +
         "><tspan font-weight=\"bold\">" + Escaped(title) + "</tspan><tspan dx=\"12\"" + Attribute("fill", kMuted) +
         ">" + Escaped(note) + "</tspan></text>\n";
}

double Across(const SvgPanel& panel, double x) { return kPanelWidth * panel.x.Fraction(x); }
double Down(const SvgPanel& panel, double y) { return kPanelHeight * (1 - panel.y.Fraction(y)); }

std::string Shade(const SvgPanel& panel) {
  const double lower = Across(panel, std::clamp(panel.clear_lower, panel.x.lower, panel.x.upper));
  const double upper = Across(panel, std::clamp(panel.clear_upper, panel.x.lower, panel.x.upper));
  std::string text;
  if (lower > 0) text += Rectangle(0, 0, lower, kPanelHeight, kShade);
  if (upper < kPanelWidth) text += Rectangle(upper, 0, kPanelWidth - upper, kPanelHeight, kShade);
  return text;
}

std::string Grid(const SvgPanel& panel) {
  std::string steps;
  for (const double tick : panel.x.ticks) steps += "M" + Px(Across(panel, tick)) + " 0V" + Px(kPanelHeight);
  for (const double tick : panel.y.ticks) steps += "M0 " + Px(Down(panel, tick)) + "H" + Px(kPanelWidth);
  return Path(steps, kGrid, 1);
}

/// A dot is a line of no length with round ends: a third of the text of a circle.
std::string Marks(const SvgPanel& panel, const SvgSeries& series) {
  std::string steps;
  bool pen_down = false;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double x = Across(panel, series.x[i]);
    const double y = Down(panel, series.y[i]);
    const bool has_place = std::isfinite(x) && std::isfinite(y);
    if (has_place) steps += (pen_down ? "L" : "M") + Px(x) + " " + Px(y);
    if (has_place && series.style.mark == SvgMark::kDots) steps += "h0";
    pen_down = has_place && series.style.mark == SvgMark::kLine;
  }
  return steps;
}

std::string Drawn(const std::string& steps, const SvgStyle& style) {
  return Path(steps, style.color, style.mark == SvgMark::kDots ? 3.2 : 1.4);
}

std::string TickLabels(const SvgPanel& panel, double left, double top) {
  std::string text;
  for (const double tick : panel.x.ticks)
    text += Text(left + Across(panel, tick), top + kPanelHeight + kLabelBelow, "middle", kText, FormatNumber(tick));
  for (const double tick : panel.y.ticks)
    text += Text(left - 5, top + Down(panel, tick) + 4, "end", kText, FormatNumber(tick));
  return text;
}

std::string Panel(const SvgPanel& panel, double left, double top) {
  // A nested document cuts off what leaves it.
  std::string text = "<svg" + Box(left, top, kPanelWidth, kPanelHeight) + ">\n" + Shade(panel) + Grid(panel);
  for (const SvgSeries& series : panel.series) text += Drawn(Marks(panel, series), series.style);
  text += "</svg>\n<rect" + Box(left, top, kPanelWidth, kPanelHeight) + Attribute("fill", "none") +
          Attribute("stroke", kMuted) + "/>\n";
  return text + TickLabels(panel, left, top);
}

std::string Legend(const SvgSheet& sheet, double baseline) {
  constexpr double kSample = 24;
  constexpr double kEntryPitch = 120;
  const double middle = baseline - 4;
  std::string text;
  double x = kLeft;
  for (const SvgStyle& style : sheet.legend) {
    const bool dots = style.mark == SvgMark::kDots;
    std::string steps = "M" + Px(x) + " " + Px(middle) + (dots ? "h0" : "h" + Px(kSample));
    for (double dot = 8; dots && dot <= kSample; dot += 8) steps += "m8 0h0";
    text += Drawn(steps, style) + Text(x + kSample + 8, baseline, "start", kText, style.label);
    x += kEntryPitch;
  }
  return text;
}

std::string Head(const SvgSheet& sheet) {
  std::string text =
      Heading(kLeft, 20, sheet.title, "") + Legend(sheet, 42) + Text(kLeft, 62, "start", kMuted, sheet.note);
  for (std::size_t c = 0; c < sheet.columns.size(); ++c)
    text +=
        Text(kLeft + kColumnPitch * static_cast<double>(c) + kPanelWidth / 2, 88, "middle", kText, sheet.columns[c]);
  return text;
}

std::string Row(const SvgRow& row, double top) {
  std::string text = Heading(kLeft, top - kTitleAbove, row.title, row.note);
  for (std::size_t c = 0; c < row.panels.size(); ++c)
    text += Panel(row.panels[c], kLeft + kColumnPitch * static_cast<double>(c), top);
  return text;
}

void Check(const SvgSheet& sheet) {
  if (sheet.columns.empty()) throw std::invalid_argument("a sheet needs a column");
  for (const SvgRow& row : sheet.rows) {
    if (row.panels.size() != sheet.columns.size())
      throw std::invalid_argument("row '" + row.title + "' needs one panel per column");
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
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + Box(0, 0, width, height) +
                     Attribute("viewBox", "0 0 " + Px(width) + " " + Px(height)) +
                     Attribute("font-family", "Helvetica, Arial, sans-serif") + Attribute("font-size", "12") + ">\n" +
                     "<title>" + Escaped(sheet.title) + "</title>\n" + Rectangle(0, 0, width, height, "#fff") +
                     Head(sheet);
  for (std::size_t r = 0; r < sheet.rows.size(); ++r)
    text += Row(sheet.rows[r], kTop + kRowPitch * static_cast<double>(r));
  for (std::size_t c = 0; c < sheet.columns.size(); ++c)
    text += Text(kLeft + kColumnPitch * static_cast<double>(c) + kPanelWidth / 2, height - 9, "middle", kText,
                 sheet.x_label);
  return text + "</svg>\n";
}

}  // namespace fourpost
