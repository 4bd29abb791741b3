#include "vehicles/requests/history_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/charts/svg_chart.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"

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

/// Sums of so many neighbours, from each to the last that has them.
Eigen::ArrayXd RunningSums(const Eigen::ArrayXd& values, Index length) {
  Eigen::ArrayXd sums(values.size() - length + 1);
  double sum = values.head(length).sum();
  sums[0] = sum;
  for (Index k = 1; k < sums.size(); ++k) {
    sum += values[k + length - 1] - values[k - 1];
    sums[k] = sum;
  }
  return sums;
}

/// The second about which most happens, half of a history shorter than two: the sum of all channels' squares, each over
/// its mean square and weighed by a triangle, so that a peak comes to the middle, is largest.
Window LiveliestSecond(const std::vector<HistoryChannel>& channels, double rate_Hz) {
  const Index count = channels.front().values.size();
  const Index half = std::max<Index>(1, std::min<Index>(std::lround(rate_Hz / 2), count / 4));
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(count);
  for (const HistoryChannel& channel : channels) {
    const Eigen::ArrayXd square = (channel.values.array() - channel.values.mean()).square();
    if (square.sum() > 0) power += square / square.sum();
  }
  Index first = 0;
  RunningSums(RunningSums(power, half), half).maxCoeff(&first);
  return {first, 2 * half};
}

std::string Size(const HistoryChannel& channel) {
  const Extent extent = ExtentOf(channel.values);
  return "rms " + ShortNumber(extent.rms) + ", peak " + ShortNumber(extent.peak);
}

/// The whole history and the window.
std::array<SvgPanel, 2> Panels(const HistoryChannel& channel, double start_s, double rate_Hz, const Window& window) {
  SvgPanel all = Panel(channel, start_s, rate_Hz, 0, channel.values.size());
  all.title = channel.name + " [" + channel.unit + "]";
  all.note = Size(channel);
  return {std::move(all), Panel(channel, start_s, rate_Hz, window.first, window.first + window.count)};
}

/// "15 to 16 s"
std::string Span(double start_s, double rate_Hz, const Window& window) {
  const double from = start_s + static_cast<double>(window.first) / rate_Hz;
  const auto shown = [](double t) { return FormatNumber(std::round(100 * t) / 100); };
  return shown(from) + " to " + shown(from + static_cast<double>(window.count) / rate_Hz) + " s";
}

}  // namespace

std::string HistorySvg(const std::string& title, const std::string& note, double start_s, double rate_Hz,
                       const std::vector<HistoryChannel>& channels) {
  if (channels.empty()) throw std::invalid_argument("a chart of a history needs a channel");
  if (channels.front().values.size() < 2) throw std::invalid_argument("a chart of a history needs two samples");
  const Window window = LiveliestSecond(channels, rate_Hz);
  const std::size_t in_row = std::min<std::size_t>(2, channels.size());
  SvgSheet sheet{.title = title, .note = note, .x_label = "time [s]"};
  for (std::size_t i = 0; i < in_row; ++i) {
    sheet.columns.emplace_back("all of it");
    sheet.columns.push_back(Span(start_s, rate_Hz, window));
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (c % in_row == 0) sheet.rows.emplace_back();
    for (SvgPanel& panel : Panels(Readable(channels[c]), start_s, rate_Hz, window))
      sheet.rows.back().panels.push_back(std::move(panel));
  }
  return SvgText(sheet);
}

}  // namespace fourpost
