#include "identify/experiments/time_history/history_fit_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/charts/svg_chart.h"
#include "analysis/files/csv_writer.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr Index kSlices = 500;
/// Of an outline: a cycle or more where it is not followed.
constexpr Index kOutline = 60;
const SvgStyle kMeasured{.label = "measured", .color = "#000000"};
const SvgStyle kModelled{.label = "modelled", .color = "#D55E00"};

struct Column {
  std::string name;
  std::string unit;
};

/// Of all recordings, in the order in which they come.
std::vector<Column> ColumnsOf(const std::vector<MeasuredHistory>& histories) {
  std::vector<Column> columns;
  for (const MeasuredHistory& history : histories)
    for (const MeasuredSignal& signal : history.signals)
      if (std::none_of(columns.begin(), columns.end(),
                       [&](const Column& column) { return column.name == signal.name; }))
        columns.push_back({signal.name, signal.unit});
  return columns;
}

/// More than any sensor resolves.
constexpr int kSignalDigits = 7;

/// Samples first to first + count - 1.
struct Window {
  Index first = 0;
  Index count = 0;
};

/// The window of `length` in [first, last) in which the signals, each over its own mean square, are largest.
Window Liveliest(const MeasuredHistory& history, Index first, Index last, Index length) {
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(last - first);
  for (const MeasuredSignal& signal : history.signals)
    power += signal.values.segment(first, last - first).array().square() / signal.values.squaredNorm();
  Window best{first, std::min(length, last - first)};
  double sum = power.head(best.count).sum();
  double most = sum;
  for (Index k = best.count; k < power.size(); ++k) {
    sum += power[k] - power[k - best.count];
    if (sum <= most) continue;
    most = sum;
    best.first = first + k - best.count + 1;
  }
  return best;
}

/// Of short numbers.
std::string ReadableUnit(const std::string& unit) {
  if (unit == "m") return "mm";
  return unit == "N" ? "kN" : unit;
}

double ReadableScale(const std::string& unit) {
  if (unit == "m") return 1e3;
  return unit == "N" ? 1e-3 : 1;
}

class Panels {
 public:
  Panels(const MeasuredHistory& history, const MeasuredSignal& signal, const Eigen::VectorXd& modelled)
      : history_(history),
        scale_(ReadableScale(signal.unit)),
        measured_(scale_ * signal.values),
        modelled_(scale_ * modelled) {
    extent_ = std::max(measured_.cwiseAbs().maxCoeff(), modelled_.cwiseAbs().maxCoeff());
  }

  SvgPanel Overlay(const Window& window) const {
    SvgPanel panel = Empty(window, extent_);
    panel.series = {Series(kMeasured, measured_, window)};
    // Filled, the model would hide the measurement: its outline does not.
    if (SliceOf(window) == 1) panel.series.push_back(Series(kModelled, modelled_, window));
    else
      for (const bool greatest : {false, true}) panel.series.push_back(Outline(kModelled, modelled_, window, greatest));
    return panel;
  }

  SvgPanel Close(const Window& window) const {
    SvgPanel panel = Overlay(window);
    panel.y = Axis(std::max(measured_.segment(window.first, window.count).cwiseAbs().maxCoeff(),
                            modelled_.segment(window.first, window.count).cwiseAbs().maxCoeff()));
    return panel;
  }

  SvgPanel Error(const Window& window) const {
    SvgPanel panel = Empty(window, extent_);
    panel.series = {Series(kModelled, modelled_ - measured_, window)};
    return panel;
  }

 private:
  static ChartAxis Axis(double extent) { return LinearAxis(-extent, extent, 5); }

  double TimeAt(Index k) const { return history_.TimeAt(k); }

  SvgPanel Empty(const Window& window, double extent) const {
    SvgPanel panel;
    panel.x = LinearAxis(TimeAt(window.first), TimeAt(window.first + window.count - 1), 5);
    panel.x.lower = TimeAt(window.first);
    panel.x.upper = TimeAt(window.first + window.count - 1);
    const double margin = 0.02 * (panel.x.upper - panel.x.lower);
    std::erase_if(panel.x.ticks, [&](double tick) { return tick < panel.x.lower || tick > panel.x.upper - margin; });
    panel.y = Axis(extent);
    return panel;
  }

  static Index SliceOf(const Window& window) { return std::max<Index>(1, window.count / kSlices); }

  /// Least or greatest of each stretch.
  SvgSeries Outline(const SvgStyle& style, const Eigen::VectorXd& values, const Window& window, bool greatest) const {
    SvgSeries series{.style = style};
    const Index stretch = std::max<Index>(1, window.count / kOutline);
    for (Index k = window.first; k < window.first + window.count; k += stretch) {
      const auto part = values.segment(k, std::min(stretch, window.first + window.count - k));
      series.x.push_back(TimeAt(k + part.size() / 2));
      series.y.push_back(greatest ? part.maxCoeff() : part.minCoeff());
    }
    return series;
  }

  /// Samples; where there are many, least and greatest of each slice.
  SvgSeries Series(const SvgStyle& style, const Eigen::VectorXd& values, const Window& window) const {
    SvgSeries series{.style = style};
    const auto add = [&](Index k, double value) {
      series.x.push_back(TimeAt(k));
      series.y.push_back(value);
    };
    const Index slice = SliceOf(window);
    for (Index k = window.first; k < window.first + window.count; k += slice) {
      const auto part = values.segment(k, std::min(slice, window.first + window.count - k));
      add(k, part.minCoeff());
      if (slice > 1) add(k, part.maxCoeff());
    }
    return series;
  }

  const MeasuredHistory& history_;
  double scale_;
  Eigen::VectorXd measured_;
  Eigen::VectorXd modelled_;
  double extent_ = 0;
};

std::string Span(const MeasuredHistory& history, const Window& window) {
  const auto shown = [](double t) { return FormatNumber(std::round(100 * t) / 100); };
  return shown(history.TimeAt(window.first)) + " to " + shown(history.TimeAt(window.first + window.count - 1)) + " s";
}

}  // namespace

std::string HistoryFitCsv(const std::vector<MeasuredHistory>& histories, const std::vector<Eigen::MatrixXd>& modelled) {
  const std::vector<Column> columns = ColumnsOf(histories);
  std::vector<std::string> names{"recording", "time"};
  for (const Column& column : columns)
    for (const char* kind : {"_measured", "_modelled"}) names.push_back(column.name + kind);
  CsvWriter csv(names);
  csv.Add("").Add("s");
  for (const Column& column : columns) csv.Add(column.unit).Add(column.unit);
  for (std::size_t h = 0; h < histories.size(); ++h)
    for (Index k = 0; k < histories[h].count; ++k) {
      csv.Add(histories[h].name).Add(AtDigits(histories[h].TimeAt(k), kSignalDigits));
      for (const Column& column : columns) {
        const auto& signals = histories[h].signals;
        const auto found = std::find_if(signals.begin(), signals.end(),
                                        [&](const auto& signal) { return signal.name == column.name; });
        if (found == signals.end()) csv.Add("").Add("");
        else
          csv.Add(AtDigits(found->values[k], kSignalDigits))
              .Add(AtDigits(modelled[h](k, found - signals.begin()), kSignalDigits));
      }
    }
  return csv.text();
}

std::string HistoryFitSvg(const MeasuredHistory& history, const Eigen::MatrixXd& modelled,
                          const std::vector<HistoryMisfit>& misfits) {
  const Window all{0, history.count};
  const auto length = static_cast<Index>(std::lround(history.rate_Hz));
  const std::array<Window, 2> close{Liveliest(history, 0, history.count / 2, length),
                                    Liveliest(history, history.count / 2, history.count, length)};
  SvgSheet sheet{
      .title = "Recording '" + history.name + "': measured and modelled",
      .legend = {kMeasured, kModelled},
      .columns = {"all of it", Span(history, close[0]), Span(history, close[1]), "error: modelled - measured"},
      .x_label = "time [s]"};
  for (std::size_t i = 0; i < history.signals.size(); ++i) {
    const MeasuredSignal& signal = history.signals[i];
    const Panels panels(history, signal, modelled.col(static_cast<Index>(i)));
    sheet.rows.push_back(
        {.title = signal.name + " [" + ReadableUnit(signal.unit) + "]",
         .note = "NMSE " + ShortNumber(misfits[i].nmse_percent) + " %",
         .panels = {panels.Overlay(all), panels.Close(close[0]), panels.Close(close[1]), panels.Error(all)}});
  }
  return SvgText(sheet);
}

}  // namespace fourpost
