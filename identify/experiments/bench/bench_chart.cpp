#include "identify/experiments/bench/bench_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "analysis/charts/svg_chart.h"
#include "analysis/text/short_number.h"
#include "identify/experiments/bench/bench_cycle.h"

namespace fourpost {
namespace {

const std::array<double, 7> kFrequencies_Hz = {1, 2, 5, 10, 15, 20, 25};
/// From here on in panels of their own.
constexpr double kFast_Hz = 10;
/// Of them, dark to light, told apart by those who see colours otherwise, too.
const std::array<const char*, 7> kColors = {"#000000", "#0072B2", "#56B4E9", "#009E73",
                                            "#E69F00", "#D55E00", "#CC79A7"};

const SvgStyle kMeasured{.label = "measured", .color = "#888888", .mark = SvgMark::kDots};
const SvgStyle kModelled{.label = "modelled", .color = "#D55E00", .mark = SvgMark::kLine};

/// Of many cycles, the model's within the measured ones.
const SvgStyle kManyMeasured{.label = "measured", .color = "#A8A8A8", .mark = SvgMark::kDots, .width = 5};
const SvgStyle kManyModelled{.label = "modelled", .color = "#D55E00", .mark = SvgMark::kDots, .width = 2.6};
/// Of the panels that hold all recordings [px].
constexpr double kWide = 400;
constexpr double kHigh = 240;

/// A cycle of a recording that stands for a frequency.
struct ChosenCycle {
  const ModelledRecording* of = nullptr;
  BenchCycle cycle;
  std::size_t frequency = 0;
};

/// The cycle next to a frequency, at most 8 % off.
std::optional<BenchCycle> CycleAt(const std::vector<BenchCycle>& cycles, double frequency_Hz) {
  std::optional<BenchCycle> best;
  double least = 0.08;
  for (const BenchCycle& cycle : cycles) {
    const double off = std::abs(std::log(cycle.frequency_Hz / frequency_Hz));
    if (off >= least) continue;
    least = off;
    best = cycle;
  }
  return best;
}

std::vector<ChosenCycle> ChosenCycles(const std::vector<ModelledRecording>& recordings) {
  std::vector<ChosenCycle> chosen;
  for (const ModelledRecording& recording : recordings) {
    std::vector<BenchCycle> cycles = CyclesOf(recording.recording);
    // A sine grows at first.
    if (cycles.size() > 4) cycles.erase(cycles.begin(), cycles.begin() + 2);
    for (std::size_t i = 0; i < kFrequencies_Hz.size(); ++i)
      if (const std::optional<BenchCycle> cycle = CycleAt(cycles, kFrequencies_Hz[i]))
        chosen.push_back({&recording, *cycle, i});
  }
  return chosen;
}

enum class Over { kDisplacement, kSpeed };

/// Force of a cycle over displacement [mm] or speed [m/s] as the rig would have recorded them.
SvgSeries Curve(const ChosenCycle& chosen, const std::vector<double>& force, Over over, SvgStyle style) {
  const BenchRecording& recording = chosen.of->recording;
  const BenchMotion& motion = recording.motion;
  std::vector<double> x(recording.force.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = over == Over::kSpeed ? motion.rate[k * motion.steps] : 1e3 * motion.extension[k * motion.steps];
  if (recording.filter) recording.filter->Apply(x);
  SvgSeries series{.style = std::move(style)};
  for (std::size_t k = chosen.cycle.first; k < chosen.cycle.end; ++k) {
    series.x.push_back(x[k]);
    series.y.push_back(force[k]);
  }
  return series;
}

ChartAxis AxisOf(const std::vector<SvgSeries>& series, std::vector<double> SvgSeries::*values) {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  for (const SvgSeries& one : series) {
    for (const double value : one.*values) {
      lower = std::min(lower, value);
      upper = std::max(upper, value);
    }
  }
  lower = std::min(lower, 0.0);
  upper = std::max(upper, lower + 1e-9);
  // Lines and dots are wider than nothing: none on the frame.
  const double margin = 0.02 * (upper - lower);
  return LinearAxis(lower < 0 ? lower - margin : 0, upper + margin, 5);
}

SvgPanel PanelOf(std::vector<SvgSeries> series) {
  SvgPanel panel;
  panel.x = AxisOf(series, &SvgSeries::x);
  panel.y = AxisOf(series, &SvgSeries::y);
  panel.series = std::move(series);
  return panel;
}

double AmplitudeOf(const ChosenCycle& chosen) {
  const BenchMotion& motion = chosen.of->recording.motion;
  const auto begin = motion.extension.begin();
  const auto at = [&](std::size_t k) { return begin + static_cast<std::ptrdiff_t>(k * motion.steps); };
  const auto [least, most] = std::minmax_element(at(chosen.cycle.first), at(chosen.cycle.end - 1));
  return 0.5 * (*most - *least);
}

/// Both diagrams of a cycle.
std::array<SvgPanel, 2> DiagramPanels(const ChosenCycle& chosen) {
  const auto panel = [&](Over over) {
    return PanelOf(
        {Curve(chosen, chosen.of->recording.force, over, kMeasured), Curve(chosen, chosen.of->force, over, kModelled)});
  };
  SvgPanel work = panel(Over::kDisplacement);
  work.title = chosen.of->recording.name;
  work.note = ShortNumber(chosen.cycle.frequency_Hz) + " Hz, " + ShortNumber(1e3 * AmplitudeOf(chosen)) + " mm";
  return {std::move(work), panel(Over::kSpeed)};
}

SvgStyle FrequencyStyle(std::size_t frequency) {
  return {
      .label = ShortNumber(kFrequencies_Hz[frequency]) + " Hz", .color = kColors[frequency], .mark = SvgMark::kLine};
}

/// The panel of all, and one of a quantity of the equivalents.
template <typename Value>
SvgPanel EquivalentPanel(const std::vector<LinearEquivalent>& cycles, const std::string& title, Value value) {
  SvgSeries measured{.style = kManyMeasured};
  SvgSeries modelled{.style = kManyModelled};
  for (const LinearEquivalent& cycle : cycles) {
    for (auto [series, stiffness] : {std::pair(&measured, cycle.measured), std::pair(&modelled, cycle.modelled)}) {
      series->x.push_back(cycle.frequency_Hz);
      series->y.push_back(value(cycle, stiffness));
    }
  }
  SvgPanel panel = PanelOf({measured, modelled});
  panel.title = title;
  const auto [least, most] = std::minmax_element(measured.x.begin(), measured.x.end());
  panel.x = LogAxis(0.9 * *least, 1.1 * *most);
  return panel;
}

/// Measured and modelled force over speed, on the same axes.
std::array<SvgPanel, 2> SpeedPanels(std::span<const ChosenCycle> cycles) {
  std::vector<SvgSeries> measured;
  std::vector<SvgSeries> modelled;
  for (const ChosenCycle& cycle : cycles) {
    measured.push_back(Curve(cycle, cycle.of->recording.force, Over::kSpeed, FrequencyStyle(cycle.frequency)));
    modelled.push_back(Curve(cycle, cycle.of->force, Over::kSpeed, FrequencyStyle(cycle.frequency)));
  }
  std::vector<SvgSeries> all = measured;
  all.insert(all.end(), modelled.begin(), modelled.end());
  const SvgPanel axes = PanelOf(std::move(all));
  std::array<SvgPanel, 2> panels = {axes, axes};
  panels[0].series = std::move(measured);
  panels[1].series = std::move(modelled);
  return panels;
}

}  // namespace

std::string DiagramSvg(const std::string& title, const std::vector<ModelledRecording>& recordings) {
  SvgSheet sheet{.title = title, .legend = {kMeasured, kModelled}};
  sheet.note = "Force [N] over displacement [mm] and over speed [m/s], one cycle each.";
  for (int i = 0; i < 2; ++i)
    for (const char* column : {"over displacement [mm]", "over speed [m/s]"}) sheet.columns.emplace_back(column);
  for (const ChosenCycle& chosen : ChosenCycles(recordings)) {
    if (sheet.rows.empty() || sheet.rows.back().panels.size() == 4) sheet.rows.emplace_back();
    for (SvgPanel& panel : DiagramPanels(chosen)) sheet.rows.back().panels.push_back(std::move(panel));
  }
  return SvgText(sheet);
}

std::string FrequencySvg(const std::string& title, const std::vector<ModelledRecording>& recordings) {
  SvgSheet sheet{.title = title, .note = "Force [N] over speed [m/s], a cycle of each recording near each frequency."};
  sheet.columns = {"measured", "modelled"};
  sheet.panel_width = kWide;
  sheet.panel_height = kHigh;
  std::vector<ChosenCycle> cycles = ChosenCycles(recordings);
  std::stable_sort(cycles.begin(), cycles.end(),
                   [](const ChosenCycle& a, const ChosenCycle& b) { return a.frequency < b.frequency; });
  for (std::size_t i = 0; i < cycles.size(); ++i)
    if (i == 0 || cycles[i].frequency != cycles[i - 1].frequency)
      sheet.legend.push_back(FrequencyStyle(cycles[i].frequency));
  // The fast ones are small beside the slow ones.
  const auto fast = std::find_if(cycles.begin(), cycles.end(),
                                 [](const ChosenCycle& cycle) { return kFrequencies_Hz[cycle.frequency] >= kFast_Hz; });
  for (const std::span<const ChosenCycle> group : {std::span(cycles.begin(), fast), std::span(fast, cycles.end())}) {
    if (group.empty()) continue;
    SvgRow row;
    for (SvgPanel& panel : SpeedPanels(group)) row.panels.push_back(std::move(panel));
    row.title = ShortNumber(kFrequencies_Hz[group.front().frequency]) + " to " +
                ShortNumber(kFrequencies_Hz[group.back().frequency]) + " Hz";
    sheet.rows.push_back(std::move(row));
  }
  if (sheet.rows.empty()) sheet.columns = {"no cycles"};
  return SvgText(sheet);
}

std::string EquivalentSvg(const std::string& title, const std::vector<ModelledRecording>& recordings) {
  SvgSheet sheet{.title = title, .legend = {kManyMeasured, kManyModelled}};
  sheet.columns = {"equivalent damping [N s/m]", "dynamic stiffness [N/mm]"};
  sheet.panel_width = kWide;
  sheet.panel_height = kHigh;
  sheet.x_label = "frequency [Hz]";
  std::vector<LinearEquivalent> cycles;
  for (const ModelledRecording& recording : recordings) {
    const std::vector<LinearEquivalent> some = LinearEquivalents(recording);
    cycles.insert(cycles.end(), some.begin(), some.end());
  }
  if (cycles.size() < 2) return SvgText(sheet);
  SvgRow row;
  row.panels = {
      EquivalentPanel(cycles, "",
                      [](const LinearEquivalent& cycle, const std::complex<double>& k) { return cycle.Damping(k); }),
      EquivalentPanel(cycles, "",
                      [](const LinearEquivalent&, const std::complex<double>& k) { return 1e-3 * std::abs(k); })};
  sheet.rows = {row};
  return SvgText(sheet);
}

}  // namespace fourpost
