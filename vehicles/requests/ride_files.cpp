#include "vehicles/requests/ride_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/charts/svg_chart.h"
#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/history_files.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// Distinct for people who see few colours (Okabe and Ito).
constexpr std::array<const char*, 6> kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
constexpr std::size_t kMostPoints = 4;

Json FiniteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json MetricsJson(const RideMetrics& metrics) {
  Json list = Json::array();
  for (const NamedMetric& metric : NamedMetrics(metrics))
    list.push_back({{"name", metric.name}, {"value", FiniteOrNull(metric.value)}, {"unit", metric.unit}});
  return list;
}

Json SpeedsJson(const RideMetrics& metrics) {
  Json list = Json::array();
  for (const RideMetrics::Strut& strut : metrics.struts)
    list.push_back({{"damper", strut.damper}, {"bounds_mps", kDamperSpeeds}, {"shares", strut.speed_share}});
  return list;
}

Json GainsJson(const std::vector<BodyGain>& gains) {
  Json list = Json::array();
  for (const BodyGain& gain : gains)
    list.push_back({{"pattern", gain.pattern},
                    {"largest", gain.largest},
                    {"at_Hz", gain.at_Hz},
                    {"largest_acceleration", gain.largest_acceleration},
                    {"acceleration_at_Hz", gain.acceleration_at_Hz}});
  return list;
}

Json RideOf(const RideAnswer& ride) {
  Json json = {{"motion", ride.motion}, {"way", WayOf(ride)}, {"duration_s", ride.metrics.duration_s}};
  if (ride.by_spectra) {
    json["nonlinear_elements"] = ride.nonlinear;
    json["converged"] = ride.converged;
    json["grid_change"] = ride.grid_change;
    json["gains"] = GainsJson(ride.gains);
  } else {
    json["engine"] = EngineName(ride.by.engine);
  }
  json["metrics"] = MetricsJson(ride.metrics);
  json["damper_speeds"] = SpeedsJson(ride.metrics);
  return json;
}

/// A channel of all rides, over four decades below its largest density.
SvgPanel PanelOf(const std::vector<RideAnswer>& rides, std::size_t channel) {
  SvgPanel panel;
  double largest = 0;
  double first = HUGE_VAL;
  double last = 0;
  for (std::size_t r = 0; r < rides.size(); ++r) {
    const RideSpectra& spectra = rides[r].spectra;
    SvgSeries series{.style = {.label = "", .color = kColours[r % kColours.size()]},
                     .x = spectra.frequency_Hz,
                     .y = spectra.channels[channel].density};
    for (double& density : series.y) {
      if (spectra.channels[channel].unit == "N") density *= 1e-6;
      largest = std::max(largest, density);
    }
    first = std::min(first, spectra.frequency_Hz.front());
    last = std::max(last, spectra.frequency_Hz.back());
    panel.series.push_back(std::move(series));
  }
  const RideSpectra::Channel& shown = rides.front().spectra.channels[channel];
  panel.title = shown.name + " [" + (shown.unit == "N" ? "kN^2" : "(m/s^2)^2") + "/Hz]";
  panel.x = LogAxis(first, last);
  const double top = largest > 0 ? std::pow(10, std::ceil(std::log10(largest))) : 1;
  panel.y = LogAxis(1e-4 * top, top);
  std::erase_if(panel.y.ticks, [](double tick) {
    const double decades = std::log10(tick);
    return std::abs(decades - std::round(decades)) > 1e-9;
  });
  return panel;
}

}  // namespace

const char* WayOf(const RideAnswer& ride) { return ride.by_spectra ? "spectra" : "history"; }

std::string RideCsv(const std::vector<RideAnswer>& rides) {
  CsvWriter csv({"motion", "way", "metric", "value", "unit"});
  for (const RideAnswer& ride : rides)
    for (const NamedMetric& metric : NamedMetrics(ride.metrics))
      csv.Add(ride.motion).Add(WayOf(ride)).Add(metric.name).Add(metric.value).Add(metric.unit);
  return csv.text();
}

std::string RideSpectraCsv(const std::vector<RideAnswer>& rides) {
  CsvWriter csv({"motion", "way", "channel", "frequency_Hz", "density", "unit"});
  for (const RideAnswer& ride : rides)
    for (const RideSpectra::Channel& channel : ride.spectra.channels)
      for (std::size_t k = 0; k < channel.density.size(); ++k)
        csv.Add(ride.motion)
            .Add(WayOf(ride))
            .Add(channel.name)
            .Add(ride.spectra.frequency_Hz[k])
            .Add(channel.density[k])
            .Add(channel.unit == "N" ? "N^2/Hz" : "(m/s^2)^2/Hz");
  return csv.text();
}

std::string RideJson(const Vehicle& vehicle, const std::vector<RideAnswer>& rides, const Diagnostics& findings) {
  Json parameters = Json::object();
  for (const Parameter& parameter : vehicle.parameters) parameters[parameter.name] = parameter.value;
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  Json list = Json::array();
  for (const RideAnswer& ride : rides) list.push_back(RideOf(ride));
  const Json json = {{"vehicle", vehicle.name},
                     {"parameters", parameters},
                     {"rides", list},
                     {"findings", FindingsJson(findings)},
                     {"versions", versions}};
  return JsonText(json);
}

std::string RideSvg(const std::string& vehicle, const std::vector<RideAnswer>& rides) {
  SvgSheet sheet{.title = "Ride of " + vehicle, .x_label = "frequency [Hz]"};
  for (std::size_t r = 0; r < rides.size(); ++r)
    sheet.legend.push_back({.label = rides[r].motion + (rides[r].by_spectra ? "" : ", time history"),
                            .color = kColours[r % kColours.size()]});
  std::vector<std::size_t> points;
  std::vector<std::size_t> tyres;
  const std::vector<RideSpectra::Channel>& channels = rides.front().spectra.channels;
  for (std::size_t c = 0; c < channels.size(); ++c) (channels[c].unit == "N" ? tyres : points).push_back(c);
  points.resize(std::min(points.size(), kMostPoints));
  sheet.columns.assign(std::max<std::size_t>(1, std::min<std::size_t>(2, std::max(points.size(), tyres.size()))), "");
  for (const std::vector<std::size_t>& group : {points, tyres})
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (i % sheet.columns.size() == 0) sheet.rows.emplace_back();
      sheet.rows.back().panels.push_back(PanelOf(rides, group[i]));
    }
  sheet.panel_width = 300;
  return SvgText(sheet);
}

}  // namespace fourpost
