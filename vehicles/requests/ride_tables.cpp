#include "vehicles/requests/ride_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"
#include "vehicles/description/gravity.h"
#include "vehicles/requests/engine_text.h"

namespace fourpost {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string Figure(double value, int digits = 3) { return std::isfinite(value) ? Rounded(value, digits) : "-"; }

std::string Millimetres(double metres) { return ShortNumber(1e3 * metres); }
std::string Mm(double metres) { return Figure(1e3 * metres); }
std::string Share(double share) { return share > 0 && share < 1e-5 ? "< 0.001" : Figure(1e2 * share, 2); }

RideTable ComfortTable(const RideMetrics& metrics) {
  RideTable table{
      .head = {"acceleration, m/s^2", "weighting", "a_w", "rms", "0.5-5 Hz", "5-25 Hz", "MTVV", "VDV, m/s^1.75"},
      .rows = {},
      .foot = ""};
  for (const RideMetrics::Comfort& comfort : metrics.comfort)
    table.rows.push_back({comfort.point, std::string(WeightingName(comfort.weighting)), Figure(comfort.weighted.rms),
                          Figure(comfort.rms), Figure(comfort.primary), Figure(comfort.secondary),
                          Figure(comfort.weighted.mtvv), Figure(comfort.weighted.vdv)});
  return table;
}

RideTable TyreTable(const RideMetrics& metrics) {
  RideTable table{
      .head = {"tyre", "static, kN", "rms, kN", "CPLV, %", "least, kN", "off ground, %"}, .rows = {}, .foot = ""};
  for (const RideMetrics::Wheel& wheel : metrics.wheels)
    table.rows.push_back({wheel.tyre, Figure(1e-3 * wheel.static_N), Figure(1e-3 * wheel.rms_N),
                          Figure(1e2 * wheel.Variation()), Figure(1e-3 * std::max(0.0, std::round(wheel.least_N))),
                          Share(wheel.off_ground)});
  return table;
}

RideTable AxleTable(const RideMetrics& metrics) {
  RideTable table{
      .head = {"axle", "CPLV, %", "ride height, mm rms", "sum of load variances, kN^2"}, .rows = {}, .foot = ""};
  for (const RideMetrics::Axle& axle : metrics.axles)
    table.rows.push_back({axle.name, Figure(1e2 * axle.variation),
                          axle.ride_height_rms ? Mm(*axle.ride_height_rms) : "-", Figure(1e-6 * axle.load_variance)});
  if (metrics.axles.size() > 1)
    table.rows.push_back({"car", Figure(1e2 * metrics.variation), "-", Figure(1e-6 * metrics.load_variance)});
  return table;
}

RideTable DamperTable(const RideMetrics& metrics) {
  RideTable table{.head = {"damper", "travel, mm rms", "mean, mm", "bump, mm", "rebound, mm", "speed, mm/s rms",
                           "95 %, mm/s", "power, W"},
                  .rows = {},
                  .foot = ""};
  for (const RideMetrics::Strut& strut : metrics.struts)
    table.rows.push_back({strut.damper, Mm(strut.travel_rms_m), Mm(strut.mean_m), Mm(-strut.least_m), Mm(strut.most_m),
                          Mm(strut.speed_rms), Mm(strut.speed_95), Figure(strut.power_W)});
  return table;
}

RideTable SpeedTable(const RideMetrics& metrics) {
  std::vector<std::string> head = {"% of time, speed in mm/s"};
  for (std::size_t i = 0; i < kDamperSpeeds.size(); ++i)
    head.push_back((i == 0 ? "0" : Millimetres(kDamperSpeeds[i - 1])) + "-" + Millimetres(kDamperSpeeds[i]));
  head.push_back("more");
  RideTable table{.head = std::move(head), .rows = {}, .foot = ""};
  for (const RideMetrics::Strut& strut : metrics.struts) {
    std::vector<std::string> row = {strut.damper};
    for (const double share : strut.speed_share) row.push_back(Share(share));
    table.rows.push_back(row);
  }
  return table;
}

RideTable StopTable(const RideMetrics& metrics) {
  RideTable table{.head = {"stop", "side", "gap, mm", "remaining, mm", "contact, %"}, .rows = {}, .foot = ""};
  for (const RideMetrics::Stop& stop : metrics.stops)
    table.rows.push_back(
        {stop.stop, stop.is_bump ? "bump" : "rebound", Mm(stop.gap_m), Mm(stop.left_m), Share(stop.contact)});
  return table;
}

const BodyGain* GainOf(const RideAnswer& ride, const char* pattern) {
  for (const BodyGain& gain : ride.gains)
    if (gain.pattern == pattern) return &gain;
  return nullptr;
}

std::string At(double value, double frequency_Hz) { return Figure(value) + " at " + Figure(frequency_Hz, 2) + " Hz"; }

/// Gains per millimetre of the posts.
RideTable BodyTable(const RideAnswer& ride, const RideMetrics::Body& body) {
  RideTable table{.head = {"body", "rms", "acceleration rms", "We", "largest gain", "largest acceleration gain"},
                  .rows = {},
                  .foot = ""};
  const BodyGain* heave = GainOf(ride, "heave");
  table.rows.push_back(
      {"heave", Mm(body.heave_rms) + " mm", Figure(body.heave_acceleration) + " m/s^2", "-",
       heave ? At(heave->largest, heave->at_Hz) + ", mm/mm" : "-",
       heave ? At(1e-3 * heave->largest_acceleration / kGravity, heave->acceleration_at_Hz) + ", g/mm" : "-"});
  const auto turn = [&](const char* name, double rms, double acceleration, double weighted) {
    if (rms == 0) return;
    const BodyGain* gain = GainOf(ride, name);
    table.rows.push_back(
        {name, Figure(rms / kDegree) + " deg", Figure(acceleration) + " rad/s^2", Figure(weighted) + " rad/s^2",
         gain ? At(1e-3 * gain->largest / kDegree, gain->at_Hz) + ", deg/mm" : "-",
         gain ? At(1e-3 * gain->largest_acceleration, gain->acceleration_at_Hz) + ", rad/s^2/mm" : "-"});
  };
  turn("pitch", body.pitch_rms, body.pitch_acceleration, body.pitch_weighted);
  turn("roll", body.roll_rms, body.roll_acceleration, body.roll_weighted);
  table.foot = "mean heave " + Mm(body.mean_heave) + " mm (dampers' jacking, stops)";
  return table;
}

}  // namespace

std::string RideMethod(const RideAnswer& ride) {
  if (!ride.by_spectra) return "time history";
  std::string text = "power spectra";
  if (ride.nonlinear > 0)
    text += ", " + std::to_string(ride.nonlinear) +
            (ride.nonlinear == 1 ? " nonlinear element" : " nonlinear elements") + " by statistical linearisation";
  return text;
}

std::vector<RideTable> RideTables(const RideAnswer& ride) {
  std::vector<RideTable> tables = {ComfortTable(ride.metrics), TyreTable(ride.metrics),  AxleTable(ride.metrics),
                                   DamperTable(ride.metrics),  SpeedTable(ride.metrics), StopTable(ride.metrics)};
  if (ride.metrics.body) tables.push_back(BodyTable(ride, *ride.metrics.body));
  std::erase_if(tables, [](const RideTable& table) { return table.rows.empty(); });
  return tables;
}

std::string RideFoot(const RideAnswer& ride) {
  if (!ride.by_spectra) return EngineText(ride.by);
  return "Peaks and doses are those of normal motion over " + ShortNumber(ride.metrics.duration_s) +
         " s; error of the grid " + Percent(ride.grid_change, 1) + ".\n";
}

}  // namespace fourpost
