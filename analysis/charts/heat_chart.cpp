#include "analysis/charts/heat_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "analysis/charts/svg_element.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

// Lengths in pixels.
constexpr double kMapTop = 96;
constexpr double kMapFoot = 44;
constexpr double kMapRight = 170;
constexpr double kLargestCell = 34;
constexpr double kSmallestCell = 3;
constexpr double kMapSize = 520;
constexpr double kLetterWidth = 7;

using Color = std::array<double, 3>;
// Of Okabe and Ito, which the colour-blind distinguish.
constexpr Color kBelowZero = {0, 114, 178};
constexpr Color kAboveZero = {213, 94, 0};

/// From white at 0 to the colour at 1.
std::string Shaded(const Color& color, double share) {
  std::array<int, 3> mixed = {};
  for (std::size_t i = 0; i < mixed.size(); ++i)
    mixed[i] = static_cast<int>(std::lround(std::lerp(255.0, color[i], std::clamp(share, 0.0, 1.0))));
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(mixed[0]) & 255U,
                static_cast<unsigned>(mixed[1]) & 255U, static_cast<unsigned>(mixed[2]) & 255U);
  return text;
}

class HeatDrawing {
 public:
  explicit HeatDrawing(const HeatChart& chart) : chart_(chart) {
    if (chart.cells.empty() || chart.columns.empty()) throw std::invalid_argument("a heat map needs cells");
    if (chart.cells.size() != chart.rows.size()) throw std::invalid_argument("a heat map needs a name per row");
    for (const std::vector<HeatChart::Cell>& row : chart.cells)
      if (row.size() != chart.columns.size()) throw std::invalid_argument("a heat map needs rows of equal length");
    for (const std::optional<HeatChart::Mark>& mark : {chart.ring, chart.cross})
      if (mark && (mark->place.first >= chart.columns.size() || mark->place.second >= chart.rows.size()))
        throw std::invalid_argument("a mark lies outside the heat map");
    const auto most = static_cast<double>(std::max(chart.columns.size(), chart.rows.size()));
    cell_ = std::clamp(std::floor(kMapSize / most), kSmallestCell, kLargestCell);
    std::size_t longest = 0;
    for (const std::string& row : chart.rows) longest = std::max(longest, row.size());
    left_ = 36 + kLetterWidth * static_cast<double>(longest);
    width_ = cell_ * static_cast<double>(chart.columns.size());
    height_ = cell_ * static_cast<double>(chart.rows.size());
    FindRange();
  }

  std::string Svg() const {
    const double heads = 40 + kLetterWidth * static_cast<double>(std::max(chart_.title.size(), chart_.note.size()));
    const double width = std::max(left_ + width_ + kMapRight, heads);
    const double height = kMapTop + std::max(height_, 170.0) + kMapFoot;
    return svg::Document(width, height, chart_.title,
                         svg::Heading(14, 20, chart_.title, "") + svg::Text(14, 40, "start", svg::kMuted, chart_.note) +
                             Legend() + Cells() + Frame() + Marks() + Labels() + Scale());
  }

 private:
  void FindRange() {
    for (const std::vector<HeatChart::Cell>& row : chart_.cells)
      for (const HeatChart::Cell& cell : row) {
        if (!std::isfinite(cell.value)) continue;
        least_ = std::min(least_, cell.value);
        most_ = std::max(most_, cell.value);
      }
  }

  double Across(std::size_t column) const { return left_ + cell_ * static_cast<double>(column); }
  double Down(std::size_t row) const { return kMapTop + height_ - cell_ * static_cast<double>(row + 1); }

  /// By the root of its size over the largest one, so that little is seen beside much.
  std::string ColorOf(double value) const {
    const double size = std::max(most_, -least_);
    const double share = size > 0 ? std::sqrt(std::abs(value) / size) : 0;
    return Shaded(value < 0 ? kBelowZero : kAboveZero, share);
  }

  std::string Cells() const {
    std::string text = svg::Rectangle(left_, kMapTop, width_, height_, "#f2f2f2");
    std::string bars;
    for (std::size_t r = 0; r < chart_.rows.size(); ++r)
      for (std::size_t c = 0; c < chart_.columns.size(); ++c) {
        const HeatChart::Cell& cell = chart_.cells[r][c];
        if (!std::isfinite(cell.value)) continue;
        text += svg::Rectangle(Across(c), Down(r), cell_, cell_, ColorOf(cell.value).c_str());
        if (cell.is_barred)
          bars +=
              "M" + svg::Px(Across(c)) + " " + svg::Px(Down(r) + cell_) + "l" + svg::Px(cell_) + " " + svg::Px(-cell_);
      }
    if (!bars.empty()) text += svg::Path(bars, "#888", 1);
    return text + "<rect" + svg::Box(left_, kMapTop, width_, height_) + svg::Attribute("fill", "none") +
           svg::Attribute("stroke", svg::kMuted) + "/>\n";
  }

  bool IsFramed(std::size_t row, std::size_t column) const {
    return row < chart_.rows.size() && column < chart_.columns.size() && chart_.cells[row][column].is_framed;
  }

  /// Edges between framed cells and others.
  std::string Frame() const {
    std::string steps;
    const std::string side = svg::Px(cell_);
    for (std::size_t r = 0; r < chart_.rows.size(); ++r)
      for (std::size_t c = 0; c < chart_.columns.size(); ++c) {
        if (!IsFramed(r, c)) continue;
        const std::string corner = "M" + svg::Px(Across(c)) + " " + svg::Px(Down(r));
        const std::string opposite = "M" + svg::Px(Across(c) + cell_) + " " + svg::Px(Down(r) + cell_);
        if (!IsFramed(r + 1, c)) steps += corner + "h" + side;
        if (!IsFramed(r, c - 1)) steps += corner + "v" + side;
        if (!IsFramed(r - 1, c)) steps += opposite + "h-" + side;
        if (!IsFramed(r, c + 1)) steps += opposite + "v-" + side;
      }
    return steps.empty() ? "" : svg::Path(steps, svg::kText, 2.4);
  }

  static std::string Ring(double x, double y, double radius) {
    return "<circle" + svg::Attribute("cx", svg::Px(x)) + svg::Attribute("cy", svg::Px(y)) +
           svg::Attribute("r", svg::Px(radius)) + svg::Attribute("fill", "none") +
           svg::Attribute("stroke", svg::kText) + svg::Attribute("stroke-width", "2") + "/>\n";
  }

  static std::string Cross(double x, double y, double radius) {
    const std::string size = svg::Px(2 * radius);
    return svg::Path("M" + svg::Px(x - radius) + " " + svg::Px(y - radius) + "l" + size + " " + size + "M" +
                         svg::Px(x - radius) + " " + svg::Px(y + radius) + "l" + size + " -" + size,
                     svg::kText, 2);
  }

  std::string Marks() const {
    const double radius = std::clamp(0.3 * cell_, 3.0, 7.0);
    std::string text;
    if (chart_.ring)
      text += Ring(Across(chart_.ring->place.first) + cell_ / 2, Down(chart_.ring->place.second) + cell_ / 2, radius);
    if (chart_.cross)
      text += Cross(Across(chart_.cross->place.first) + cell_ / 2, Down(chart_.cross->place.second) + cell_ / 2,
                    0.8 * radius);
    return text;
  }

  std::string Legend() const {
    std::string text;
    double x = 18;
    constexpr double kBase = 66;
    const auto entry = [&](const std::string& mark, const std::string& label) {
      text += mark + svg::Text(x + 14, kBase, "start", svg::kText, label);
      x += 40 + kLetterWidth * static_cast<double>(label.size());
    };
    if (chart_.ring) entry(Ring(x, kBase - 4, 5), chart_.ring->label);
    if (chart_.cross) entry(Cross(x, kBase - 4, 4), chart_.cross->label);
    if (!chart_.framed_label.empty())
      entry(svg::Path("M" + svg::Px(x - 6) + " " + svg::Px(kBase - 10) + "h12v12h-12z", svg::kText, 2.4),
            chart_.framed_label);
    if (!chart_.barred_label.empty())
      entry(svg::Path("M" + svg::Px(x - 6) + " " + svg::Px(kBase + 2) + "l12 -12", "#888", 1), chart_.barred_label);
    return text;
  }

  /// Every label, or every second, fifth, tenth ... where they would touch.
  static std::size_t Spacing(const std::vector<std::string>& names, double cell, bool is_across) {
    std::size_t longest = 1;
    for (const std::string& name : names) longest = std::max(longest, name.size());
    const double needed = is_across ? kLetterWidth * static_cast<double>(longest) + 6 : 14;
    std::size_t spacing = 1;
    for (const std::size_t next : {2U, 5U, 10U, 20U, 50U, 100U, 200U, 500U, 1000U})
      if (cell * static_cast<double>(spacing) < needed) spacing = next;
    return spacing;
  }

  std::string Labels() const {
    std::string text;
    const std::size_t across = Spacing(chart_.columns, cell_, true);
    for (std::size_t c = 0; c < chart_.columns.size(); c += across)
      text += svg::Text(Across(c) + cell_ / 2, kMapTop + height_ + 15, "middle", svg::kText, chart_.columns[c]);
    const std::size_t down = Spacing(chart_.rows, cell_, false);
    for (std::size_t r = 0; r < chart_.rows.size(); r += down)
      text += svg::Text(left_ - 5, Down(r) + cell_ / 2 + 4, "end", svg::kText, chart_.rows[r]);
    text += svg::Text(left_ + width_ / 2, kMapTop + height_ + 34, "middle", svg::kText, chart_.x_label);
    return text + "<g transform=\"rotate(-90)\">" +
           svg::Text(-kMapTop - height_ / 2, 16, "middle", svg::kText, chart_.y_label) + "</g>\n";
  }

  /// The colours beside the map, from the largest value down to the least.
  std::string Scale() const {
    constexpr int kPieces = 40;
    constexpr double kPiece = 4;
    const double x = left_ + width_ + 24;
    const double top = kMapTop;
    std::string text;
    const double span = most_ - least_;
    for (int i = 0; i < kPieces; ++i) {
      const double value = most_ - span * (i + 0.5) / kPieces;
      text += svg::Rectangle(x, top + kPiece * i, 16, kPiece + 0.5, ColorOf(value).c_str());
    }
    const auto label = [&](double value) {
      const double share = span > 0 ? (most_ - value) / span : 0;
      text += svg::Text(x + 22, top + kPieces * kPiece * share + 4, "start", svg::kText, Rounded(value, 3));
    };
    label(most_);
    if (least_ < most_) label(least_);
    // Zero is white, and has room between the two.
    if (least_ < -0.08 * span && most_ > 0.08 * span) label(0);
    return text + svg::Text(left_ + width_ + 14, top - 12, "start", svg::kMuted, chart_.value_label);
  }

  const HeatChart& chart_;
  double cell_ = 0;
  double left_ = 0;
  double width_ = 0;
  double height_ = 0;
  /// They always include zero.
  double least_ = 0;
  double most_ = 0;
};

}  // namespace

std::string HeatSvg(const HeatChart& chart) { return HeatDrawing(chart).Svg(); }

}  // namespace fourpost
