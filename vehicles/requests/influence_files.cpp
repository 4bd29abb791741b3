#include "vehicles/requests/influence_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "analysis/charts/bode_panel.h"
#include "analysis/files/csv_writer.h"
#include "analysis/text/units.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/linear_response.h"
#include "vehicles/condensed/mode_times.h"
#include "vehicles/condensed/state_space.h"
#include "vehicles/requests/history_channel.h"
#include "vehicles/requests/history_chart.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr double kLowest_Hz = 0.5;
constexpr double kHighest_Hz = 30;
constexpr int kFrequencies = 200;
/// From light to dark, as the parameter grows.
constexpr std::array<const char*, 5> kColors = {"#E69F00", "#56B4E9", "#009E73", "#0072B2", "#000000"};

/// Indices of five values at most, spread evenly.
std::vector<std::size_t> Shown(std::size_t count) {
  std::set<std::size_t> shown;
  for (std::size_t k = 0; k < kColors.size(); ++k) shown.insert((k * (count - 1) + 2) / (kColors.size() - 1));
  return {shown.begin(), shown.end()};
}

std::vector<double> Frequencies() {
  std::vector<double> frequencies(kFrequencies);
  for (int k = 0; k < kFrequencies; ++k)
    frequencies[static_cast<std::size_t>(k)] =
        kLowest_Hz * std::pow(kHighest_Hz / kLowest_Hz, static_cast<double>(k) / (kFrequencies - 1));
  return frequencies;
}

/// Sensors x frequencies, accelerometers against the posts' acceleration as everywhere.
std::vector<std::vector<std::complex<double>>> Responses(const Vehicle& vehicle, const CondensedModel& model,
                                                         const std::vector<double>& frequencies) {
  std::vector<std::vector<std::complex<double>>> responses(vehicle.sensors.size());
  for (const double frequency : frequencies) {
    const Eigen::VectorXcd all = LinearResponse(model, frequency).rowwise().sum();
    for (std::size_t i = 0; i < responses.size(); ++i) {
      const bool is_acceleration = UnitOf(vehicle.sensors[i].type) == "m/s^2";
      const double reference = is_acceleration ? -std::pow(2 * M_PI * frequency, 2) : 1;
      responses[i].push_back(all[static_cast<Index>(i)] / reference);
    }
  }
  return responses;
}

std::string InUnits(double si, const Parameter& parameter) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", si / ParseUnit(parameter.unit.empty() ? "1" : parameter.unit)->si);
  return std::string(text) + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

}  // namespace

std::string InfluenceSvg(const Vehicle& vehicle, const PolePaths& paths) {
  const Parameter& parameter = vehicle.parameters[paths.parameter];
  const std::vector<double> frequencies = Frequencies();
  SvgSheet sheet{.title = "Responses of " + vehicle.name + " over " + parameter.name,
                 .note = "all posts alike, small motions, dashpots at their mean rates",
                 .columns = {"gain [dB]", "phase [deg]"},
                 .x_label = "frequency [Hz]"};
  for (const Sensor& sensor : vehicle.sensors) {
    SvgRow row{.title = sensor.name, .note = GainReference(UnitOf(sensor.type)), .panels = {{}, {}}};
    for (SvgPanel& panel : row.panels) panel.x = FrequencyAxis(kLowest_Hz, kHighest_Hz);
    row.panels[1].y = PhaseAxis();
    sheet.rows.push_back(std::move(row));
  }
  const CondensedVehicle condensed(vehicle);
  std::vector<double> values = vehicle.ParameterValues();
  std::size_t color = 0;
  for (const std::size_t k : Shown(paths.values.size())) {
    values[paths.parameter] = paths.values[k];
    const SvgStyle style{.label = InUnits(paths.values[k], parameter), .color = kColors[color++]};
    sheet.legend.push_back(style);
    const auto responses = Responses(vehicle, condensed.At(values), frequencies);
    for (std::size_t i = 0; i < responses.size(); ++i) {
      sheet.rows[i].panels[0].series.push_back(GainSeries(frequencies, responses[i], style));
      sheet.rows[i].panels[1].series.push_back(PhaseSeries(frequencies, responses[i], style));
    }
  }
  for (SvgRow& row : sheet.rows) row.panels[0].y = GainAxis({row.panels[0]});
  return SvgText(sheet);
}

ImpulseFiles ImpulseOf(const Vehicle& vehicle, const CondensedModel& model) {
  constexpr double kRate_Hz = 1000;
  constexpr double kLongest_s = 5;
  constexpr double kShortest_s = 0.5;
  double settled_s = kShortest_s;
  for (const Mode& mode : ModesOf(model)) settled_s = std::max(settled_s, SettlingTime_s(mode));
  const auto samples = static_cast<Index>(kRate_Hz * std::min(settled_s, kLongest_s));
  // A metre second would be far off all that a rig does.
  constexpr double kImpulse_ms = 1e-3;
  const Eigen::MatrixXd readings =
      kImpulse_ms *
      StateSpace(model).ImpulseResponse(Eigen::VectorXd::Ones(model.post_stiffness.cols()), 1 / kRate_Hz, samples);
  std::vector<HistoryChannel> channels;
  std::vector<std::string> names{"time"};
  for (std::size_t i = 0; i < vehicle.sensors.size(); ++i) {
    const std::string unit = UnitOf(vehicle.sensors[i].type);
    channels.push_back({vehicle.sensors[i].name, unit, readings.col(static_cast<Index>(i))});
    names.push_back(vehicle.sensors[i].name);
  }
  CsvWriter csv(names);
  csv.Add("s");
  for (const HistoryChannel& channel : channels) csv.Add(channel.unit);
  for (Index k = 0; k < samples; ++k) {
    csv.Add(static_cast<double>(k) / kRate_Hz);
    for (const HistoryChannel& channel : channels) csv.Add(channel.values[k]);
  }
  return {
      .csv = csv.text(),
      .svg = HistorySvg("Impulse response of " + vehicle.name,
                        "after an impulse of 1 mm s of all posts, dashpots at their mean rates", 0, kRate_Hz, channels),
      .rate_Hz = kRate_Hz,
      .channels = channels};
}

}  // namespace fourpost
