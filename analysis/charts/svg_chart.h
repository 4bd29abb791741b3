#pragma once

#include <limits>
#include <string>
#include <vector>

#include "analysis/charts/chart_axis.h"

namespace fourpost {

enum class SvgMark { kDots, kLine };

/// How a series looks, and what the legend calls it.
struct SvgStyle {
  std::string label;
  /// "#0072B2"
  std::string color;
  SvgMark mark = SvgMark::kLine;
  /// Of a line, and across a dot [px]; 0: as usual.
  double width = 0;
};

/// Points of a panel, in the units of its axes. A point that is not finite, or has no place on a logarithmic axis, is
/// left out and interrupts the line.
struct SvgSeries {
  SvgStyle style;
  std::vector<double> x;
  std::vector<double> y;
};

/// One diagram. What leaves the axes' limits is cut off.
struct SvgPanel {
  /// Above it, in place of its row's; room for two panels' width.
  std::string title;
  std::string note;
  ChartAxis x;
  ChartAxis y;
  /// Left and right of these the panel is shaded.
  double clear_lower = -std::numeric_limits<double>::infinity();
  double clear_upper = std::numeric_limits<double>::infinity();
  /// From back to front.
  std::vector<SvgSeries> series;
};

/// Panels side by side, with a title and what is to be said about them; at most one per column.
struct SvgRow {
  std::string title;
  std::string note;
  std::vector<SvgPanel> panels;
};

/// Rows of panels of equal size under common column heads and one legend.
struct SvgSheet {
  std::string title;
  /// A line below the legend.
  std::string note;
  std::vector<SvgStyle> legend;
  std::vector<std::string> columns;
  /// Of every panel [px]. Four columns of these are as wide as GitHub shows a picture.
  double panel_width = 188;
  double panel_height = 116;
  /// What the horizontal axes show.
  std::string x_label;
  std::vector<SvgRow> rows;
};

/// The sheet as an SVG document on a white ground, lengths in pixels rounded to a tenth; as wide as its panels, their
/// labels, the legend and the note need. Throws std::invalid_argument for a sheet without columns, a row of more panels
/// than columns, a series with unlike numbers of x and y, and for an axis that ChartAxis::Validate refuses.
std::string SvgText(const SvgSheet& sheet);

}  // namespace fourpost
