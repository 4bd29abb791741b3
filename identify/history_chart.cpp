#include "identify/history_chart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

SvgRow Row(const HistoryChannel& channel, double start_s, double rate_Hz) {
  const Index count = channel.values.size();
  if (count < 2) throw std::invalid_argument("a chart of a history needs two samples");
  Index peak = 0;
  const double size = channel.values.cwiseAbs().maxCoeff(&peak);
  const Index second = std::clamp<Index>(std::lround(rate_Hz), 2, count);
  const Index first = std::clamp<Index>(peak - second / 2, 0, count - second);
  return {
      .title = channel.name + " [" + channel.unit + "]",
      .note = "rms " + Short(std::sqrt(channel.values.squaredNorm() / static_cast<double>(count))) + ", peak " +
              Short(size),
      .panels = {Panel(channel, start_s, rate_Hz, 0, count), Panel(channel, start_s, rate_Hz, first, first + second)}};
}

}  // namespace

std::string HistorySvg(const std::string& title, double start_s, double rate_Hz,
                       const std::vector<HistoryChannel>& channels) {
  if (channels.empty()) throw std::invalid_argument("a chart of a history needs a channel");
  SvgSheet sheet{.title = title, .columns = {"all of it", "the second about its peak"}, .x_label = "time [s]"};
  for (const HistoryChannel& channel : channels) sheet.rows.push_back(Row(Readable(channel), start_s, rate_Hz));
  return SvgText(sheet);
}

}  // namespace fourpost
