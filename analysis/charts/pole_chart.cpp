#include "analysis/charts/pole_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "analysis/charts/chart_axis.h"
#include "analysis/charts/svg_element.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

// Lengths in pixels.
constexpr double kWidth = 860;
constexpr double kHeight = 600;
constexpr double kLeft = 52;
constexpr double kTop = 74;
constexpr double kPlotWidth = kWidth - kLeft - 40;
constexpr double kPlotHeight = kHeight - kTop - 46;
constexpr double kMark = 4;

/// Colours of Okabe and Ito that the colour-blind distinguish, without the palest.
constexpr std::array<const char*, 6> kColors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"};

struct Place {
  double x = 0;
  double y = 0;
};

struct Box {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  bool Meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool IsWithin(const Box& other) const {
    return left >= other.left && right <= other.right && top >= other.top && bottom <= other.bottom;
  }
};

constexpr Box kPlot = {kLeft, kTop, kLeft + kPlotWidth, kTop + kPlotHeight};

std::string At(const Place& place) { return svg::Px(place.x) + " " + svg::Px(place.y); }

std::string Circle(const Place& place, const std::string& fill, const std::string& color) {
  return "<circle" + svg::Attribute("cx", svg::Px(place.x)) + svg::Attribute("cy", svg::Px(place.y)) +
         svg::Attribute("r", svg::Px(kMark)) + svg::Attribute("fill", fill) + svg::Attribute("stroke", color) +
         svg::Attribute("stroke-width", "1.4") + "/>\n";
}

std::string Ring(const Place& place, const std::string& color) { return Circle(place, "#fff", color); }
std::string Disc(const Place& place, const std::string& color) { return Circle(place, color, color); }

std::string Cross(const Place& place, const std::string& color) {
  const std::string across = "l" + svg::Px(2 * kMark) + " ";
  return svg::Path("M" + At({place.x - kMark, place.y - kMark}) + across + svg::Px(2 * kMark) + "M" +
                       At({place.x - kMark, place.y + kMark}) + across + svg::Px(-2 * kMark),
                   color, 1.4);
}

/// Puts names beside their marks where none covers another.
class Labels {
 public:
  void Avoid(const Place& place) {
    taken_.push_back({place.x - kMark, place.y - kMark, place.x + kMark, place.y + kMark});
  }

  std::string Put(const Place& place, const std::string& color, const std::string& text) {
    // Letters of 12 px are 7 px wide at most in the mean.
    const double width = 7.0 * static_cast<double>(text.size());
    constexpr double kHeightOfText = 13;
    for (double drop = 0; drop < kPlotHeight; drop += kHeightOfText / 2)
      for (const double sign : {1.0, -1.0})
        for (const double left : {place.x + 8, place.x - 8 - width}) {
          const double base = place.y + 4 + sign * drop;
          const Box box = {left, base - kHeightOfText + 2, left + width, base + 3};
          if (!IsFree(box)) continue;
          taken_.push_back(box);
          // A name that had to go far is led back to its mark.
          const double edge = left > place.x ? left - 2 : left + width + 2;
          const std::string lead =
              drop > kHeightOfText ? svg::Path("M" + At(place) + "L" + At({edge, base - 4}), svg::kGrid, 1) : "";
          return lead + (left > place.x ? svg::Text(left, base, "start", color, text)
                                        : svg::Text(left + width, base, "end", color, text));
        }
    return "";
  }

 private:
  bool IsFree(const Box& box) const {
    return box.IsWithin(kPlot) &&
           std::none_of(taken_.begin(), taken_.end(), [&](const Box& taken) { return box.Meets(taken); });
  }

  std::vector<Box> taken_;
};

class Drawing {
 public:
  explicit Drawing(const PoleChart& chart) : chart_(chart) {
    for (const PoleCurve& curve : chart.curves)
      if (curve.pole.size() != chart.curves.front().pole.size())
        throw std::invalid_argument("curve '" + curve.name + "' needs one pole per value");
    ScaleAxes();
    for (const PoleCurve& curve : chart.curves) moves_.push_back(Moves(curve));
  }

  std::string Svg() {
    std::string inside = Grid();
    std::string outside;
    for (std::size_t c = 0; c < chart_.curves.size(); ++c) AvoidMarks(c);
    std::size_t color = 0;
    for (std::size_t c = 0; c < chart_.curves.size(); ++c) {
      if (!IsShown(chart_.curves[c])) continue;
      if (moves_[c]) AddCurve(chart_.curves[c], kColors[color++ % kColors.size()], inside, outside);
    }
    // Those that stay put find room last.
    for (std::size_t c = 0; c < chart_.curves.size(); ++c)
      if (IsShown(chart_.curves[c]) && !moves_[c]) AddStill(chart_.curves[c], inside, outside);
    const std::string frame = "<rect" + svg::Box(kPlot.left, kPlot.top, kPlotWidth, kPlotHeight) +
                              svg::Attribute("fill", "none") + svg::Attribute("stroke", svg::kMuted) + "/>\n";
    return svg::Document(kWidth, kHeight, chart_.title,
                         Head() + "<svg" + svg::Box(0, 0, kWidth, kHeight) + svg::Attribute("clip-path", "url(#plot)") +
                             ">\n" + inside + "</svg>\n" + frame + AxisLabels() + outside);
  }

 private:
  static Complex Hertz(Complex pole) { return pole / (2 * std::numbers::pi); }

  bool IsInRange(Complex pole) const { return std::abs(Hertz(pole)) <= chart_.highest_Hz; }

  void ScaleAxes() {
    double left = 0;
    double right = 0;
    double top = 0;
    double left_real = 0;
    bool any = false;
    for (const PoleCurve& curve : chart_.curves)
      for (const Complex& pole : curve.pole) {
        if (!IsInRange(pole)) continue;
        any = true;
        const Complex hertz = Hertz(pole);
        (hertz.imag() > 0 ? left : left_real) = std::min(hertz.imag() > 0 ? left : left_real, hertz.real());
        right = std::max(right, hertz.real());
        top = std::max(top, hertz.imag());
      }
    if (!any) throw std::invalid_argument("no pole to show up to " + FormatNumber(chart_.highest_Hz) + " Hz");
    // Without an oscillation real poles make the picture.
    left = left == 0 && top == 0                    ? left_real
           : std::max(left_real, 1.3 * left) < left ? std::max(left_real, 1.3 * left)
                                                    : left;
    top = std::max(top, -left / 10);
    const double width = std::max(right - left, top / 10);
    x_ = {.lower = left - 0.06 * width, .upper = right + 0.08 * width};
    y_ = {.lower = -0.04 * top, .upper = 1.06 * top};
    for (const double tick : LinearAxis(x_.lower, x_.upper, 10).ticks)
      if (tick >= x_.lower && tick <= x_.upper) x_.ticks.push_back(tick);
    for (const double tick : LinearAxis(0, y_.upper, 10).ticks)
      if (tick <= y_.upper) y_.ticks.push_back(tick);
  }

  Place PlaceOf(Complex hertz) const {
    return {kPlot.left + kPlotWidth * x_.Fraction(hertz.real()),
            kPlot.bottom - kPlotHeight * y_.Fraction(hertz.imag())};
  }

  bool IsInside(Complex pole) const {
    if (!std::isfinite(pole.real()) || !IsInRange(pole)) return false;
    const Place place = PlaceOf(Hertz(pole));
    return place.x >= kPlot.left && place.x <= kPlot.right && place.y >= kPlot.top && place.y <= kPlot.bottom;
  }

  bool IsShown(const PoleCurve& curve) const {
    return std::any_of(curve.pole.begin(), curve.pole.end(), [&](Complex pole) { return IsInside(pole); });
  }

  /// By more than can be seen as a mark.
  bool Moves(const PoleCurve& curve) const {
    double least_x = std::numeric_limits<double>::infinity();
    double least_y = least_x;
    double most_x = -least_x;
    double most_y = -least_x;
    for (const Complex& pole : curve.pole) {
      if (!IsInside(pole)) continue;
      const Place place = PlaceOf(Hertz(pole));
      least_x = std::min(least_x, place.x);
      most_x = std::max(most_x, place.x);
      least_y = std::min(least_y, place.y);
      most_y = std::max(most_y, place.y);
    }
    return std::hypot(most_x - least_x, most_y - least_y) > 1.5 * kMark;
  }

  std::string Grid() const {
    std::string steps = "M" + At(PlaceOf(x_.lower)) + "L" + At(PlaceOf(x_.upper)) + "M" + At(PlaceOf({0, y_.lower})) +
                        "L" + At(PlaceOf({0, y_.upper}));
    const double radius = 2 * std::max(-x_.lower, y_.upper);
    for (const double ratio : kRatios) steps += "M" + At(PlaceOf(0)) + "L" + At(PlaceOf(Ray(ratio) * radius));
    for (const double tick : y_.ticks) {
      constexpr int kPieces = 60;
      for (int i = 0; tick > 0 && i <= kPieces; ++i)
        steps += (i == 0 ? "M" : "L") + At(PlaceOf(std::polar(tick, std::numbers::pi * (0.5 + 0.5 * i / kPieces))));
    }
    return "<clipPath id=\"plot\"><rect" + svg::Box(kPlot.left, kPlot.top, kPlotWidth, kPlotHeight) +
           "/></clipPath>\n" + svg::Path(steps, svg::kGrid, 1);
  }

  static Complex Ray(double ratio) { return {-ratio, std::sqrt(1 - ratio * ratio)}; }

  std::string AxisLabels() const {
    std::string text;
    for (const double tick : x_.ticks)
      text += svg::Text(PlaceOf(tick).x, kPlot.bottom + 15, "middle", svg::kText, FormatNumber(tick));
    for (const double tick : y_.ticks)
      text += svg::Text(kPlot.left - 5, PlaceOf({0, tick}).y + 4, "end", svg::kText, FormatNumber(tick));
    // Damping ratios where their lines leave the plot, above or to the left.
    for (const double ratio : kRatios) {
      const Complex ray = Ray(ratio);
      const double up = y_.upper / ray.imag();
      const double aside = x_.lower / ray.real();
      const Place end = PlaceOf(ray * std::min(up, aside));
      const std::string label = "ζ " + FormatNumber(ratio);
      if (up <= aside) text += svg::Text(end.x, end.y - 5, "middle", svg::kMuted, label);
      else text += svg::Text(end.x + 4, end.y - 3, "start", svg::kMuted, label);
    }
    const double middle = kPlot.left + kPlotWidth / 2;
    return text + svg::Text(middle, kHeight - 10, "middle", svg::kText, "real part / 2π [Hz]") +
           "<g transform=\"rotate(-90)\">" +
           svg::Text(-kPlot.top - kPlotHeight / 2, 14, "middle", svg::kText, "imaginary part / 2π [Hz]") + "</g>\n";
  }

  std::string Head() const {
    std::string text =
        svg::Heading(14, 20, chart_.title, "grey rays: damping ratio ζ; grey arcs: frequency of the mode");
    double x = 18;
    const auto entry = [&](const std::string& mark, const std::string& label) {
      text += mark + svg::Text(x + 10, 44, "start", svg::kText, label);
      x += 44 + 6.5 * static_cast<double>(label.size());
    };
    entry(Ring({x, 40}, svg::kText), chart_.first);
    entry(Disc({x, 40}, svg::kText), chart_.last);
    if (chart_.marked) entry(Cross({x, 40}, svg::kText), chart_.marked_value);
    return text;
  }

  /// The last place of a curve within the plot, and the first.
  Place EndOf(const PoleCurve& curve, bool last) const {
    Place end;
    for (std::size_t i = 0; i < curve.pole.size(); ++i) {
      const Complex pole = curve.pole[last ? i : curve.pole.size() - 1 - i];
      if (IsInside(pole)) end = PlaceOf(Hertz(pole));
    }
    return end;
  }

  void AvoidMarks(std::size_t index) {
    const PoleCurve& curve = chart_.curves[index];
    if (!IsShown(curve)) return;
    if (!moves_[index]) labels_.Avoid(EndOf(curve, true));
    else
      for (const Complex& pole : curve.pole)
        if (IsInside(pole)) labels_.Avoid(PlaceOf(Hertz(pole)));
  }

  void AddCurve(const PoleCurve& curve, const std::string& color, std::string& inside, std::string& outside) {
    std::string line;
    std::string dots;
    bool pen_down = false;
    for (const Complex& pole : curve.pole) {
      const bool has_place = std::isfinite(pole.real());
      if (has_place) line += (pen_down ? "L" : "M") + At(PlaceOf(Hertz(pole)));
      if (has_place) dots += "M" + At(PlaceOf(Hertz(pole))) + "h0";
      pen_down = has_place;
    }
    inside += svg::Path(line, color, 1.4) + svg::Path(dots, color, 3.2);
    if (IsInside(curve.pole.front())) outside += Ring(PlaceOf(Hertz(curve.pole.front())), color);
    if (IsInside(curve.pole.back())) outside += Disc(PlaceOf(Hertz(curve.pole.back())), color);
    if (chart_.marked && IsInside(curve.pole[*chart_.marked]))
      outside += Cross(PlaceOf(Hertz(curve.pole[*chart_.marked])), color);
    outside += labels_.Put(EndOf(curve, true), color, curve.name);
  }

  void AddStill(const PoleCurve& curve, std::string& inside, std::string& outside) {
    const Place place = EndOf(curve, true);
    inside += Cross(place, svg::kMuted);
    outside += labels_.Put(place, svg::kMuted, curve.name);
  }

  static constexpr std::array<double, 6> kRatios = {0.05, 0.1, 0.2, 0.3, 0.5, 0.7};

  const PoleChart& chart_;
  ChartAxis x_;
  ChartAxis y_;
  std::vector<bool> moves_;
  Labels labels_;
};

}  // namespace

std::string PoleSvg(const PoleChart& chart) {
  if (chart.curves.empty()) throw std::invalid_argument("a chart of poles needs a curve");
  return Drawing(chart).Svg();
}

}  // namespace fourpost
