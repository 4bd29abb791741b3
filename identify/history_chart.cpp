#include "identify/history_chart.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "analysis/number.h"
#include "analysis/svg_chart.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Finer than a panel's pixels.
constexpr Index kSlices = 600;

SvgStyle Line() { return {.label = "simulated", .color = "#0072B2", .mark = SvgMark::kLine}; }

/// Samples first to last - 1; where there are many, least and greatest of each slice.
SvgSeries Series(const HistoryChannel& channel, double start_s, double rate_Hz, Index first, Index last) {
  SvgSeries series{.style = Line()};
  const auto add = [&](Index k, double value) {
    series.x.push_back(start_s + static_cast<double>(k) / rate_Hz);
    series.y.push_back(value);
  };
  const Index slice = (last - first) / kSlices;
  if (slice < 4) {
    for (Index k = first; k < last; ++k) add(k, channel.values[k]);
    return series;
  }
  for (Index k = first; k < last; k += slice) {
    const auto values = channel.values.segment(k, std::min(slice, last - k));
    add(k, values.minCoeff());
    add(k, values.maxCoeff());
  }
  return series;
}

/// From the first to the last sample, ticks between.
ChartAxis TimeAxis(double lower, double upper) {
  ChartAxis axis = LinearAxis(lower, upper, 5);
  axis.lower = lower;
  axis.upper = upper;
  // A label at the very end would leave the sheet.
  std::erase_if(axis.ticks, [&](double tick) { return tick < lower || tick > upper - 0.02 * (upper - lower); });
  return axis;
}

SvgPanel Panel(const HistoryChannel& channel, double start_s, double rate_Hz, Index first, Index last) {
  SvgPanel panel;
  panel.series = {Series(channel, start_s, rate_Hz, first, last)};
  panel.x = TimeAxis(start_s + static_cast<double>(first) / rate_Hz, start_s + static_cast<double>(last - 1) / rate_Hz);
  const auto values = channel.values.segment(first, last - first);
  double lower = values.minCoeff();
  double upper = values.maxCoeff();
  // A channel that rests is a line in the middle.
  if (!(upper > lower)) {
    const double margin = std::max(1e-6, 0.1 * std::abs(upper));
    lower -= margin;
    upper += margin;
  }
  panel.y = LinearAxis(lower, upper, 5);
  return panel;
}

std::string Short(double value) {
  if (value == 0) return "0";
  const double scale = std::pow(10, 2 - std::floor(std::log10(std::abs(value))));
  return FormatNumber(std::round(value * scale) / scale);
}

/// In units of short numbers.
HistoryChannel Readable(HistoryChannel channel) {
  if (channel.unit == "m") return {channel.name, "mm", 1e3 * channel.values};
  if (channel.unit == "N") return {channel.name, "kN", 1e-3 * channel.values};
  return channel;
}

/// Samples first to first + count - 1.
struct Window {
  Index first = 0;
  Index count = 0;
};

/// The second in which most happens: the sum of all channels' squares, each over its mean square, is largest.
Window LiveliestSecond(const std::vector<HistoryChannel>& channels, double rate_Hz) {
  const Index count = channels.front().values.size();
  const Index second = std::clamp<Index>(std::lround(rate_Hz), 2, count);
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(count);
  for (const HistoryChannel& channel : channels) {
    const Eigen::ArrayXd square = (channel.values.array() - channel.values.mean()).square();
    if (square.sum() > 0) power += square / square.sum();
  }
  double sum = power.head(second).sum();
  double most = sum;
  Index first = 0;
  for (Index k = second; k < count; ++k) {
    sum += power[k] - power[k - second];
    if (sum <= most) continue;
    most = sum;
    first = k - second + 1;
  }
  return {first, second};
}

std::string Size(const HistoryChannel& channel) {
  const Extent extent = ExtentOf(channel.values);
  return "rms " + Short(extent.rms) + ", peak " + Short(extent.peak);
}

/// The whole history and, of a longer one, the window.
std::vector<SvgPanel> Panels(const HistoryChannel& channel, double start_s, double rate_Hz,
                             const std::optional<Window>& window) {
  std::vector<SvgPanel> panels = {Panel(channel, start_s, rate_Hz, 0, channel.values.size())};
  panels[0].title = channel.name + " [" + channel.unit + "]";
  panels[0].note = Size(channel);
  if (window) panels.push_back(Panel(channel, start_s, rate_Hz, window->first, window->first + window->count));
  return panels;
}

/// What the columns of one channel show.
std::vector<std::string> Heads(double start_s, double rate_Hz, const std::optional<Window>& window) {
  std::vector<std::string> heads = {"all of it"};
  if (!window) return heads;
  const double from = start_s + static_cast<double>(window->first) / rate_Hz;
  const auto shown = [](double t) { return FormatNumber(std::round(100 * t) / 100); };
  heads.push_back(shown(from) + " to " + shown(from + static_cast<double>(window->count) / rate_Hz) + " s");
  return heads;
}

}  // namespace

std::string HistorySvg(const std::string& title, double start_s, double rate_Hz,
                       const std::vector<HistoryChannel>& channels) {
  if (channels.empty()) throw std::invalid_argument("a chart of a history needs a channel");
  const Index count = channels.front().values.size();
  if (count < 2) throw std::invalid_argument("a chart of a history needs two samples");
  // A second of two is no detail.
  std::optional<Window> window;
  if (static_cast<double>(count) > 2 * rate_Hz) window = LiveliestSecond(channels, rate_Hz);
  // As many channels in a row as make four panels, but of few channels one: no sheet is empty on the right.
  constexpr std::size_t kFew = 3;
  const std::vector<std::string> heads = Heads(start_s, rate_Hz, window);
  const std::size_t in_row = channels.size() <= kFew ? 1 : 4 / heads.size();
  SvgSheet sheet{.title = title, .x_label = "time [s]"};
  for (std::size_t i = 0; i < in_row; ++i) sheet.columns.insert(sheet.columns.end(), heads.begin(), heads.end());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (c % in_row == 0) sheet.rows.emplace_back();
    std::vector<SvgPanel>& panels = sheet.rows.back().panels;
    for (SvgPanel& panel : Panels(Readable(channels[c]), start_s, rate_Hz, window)) panels.push_back(std::move(panel));
  }
  return SvgText(sheet);
}

}  // namespace fourpost
