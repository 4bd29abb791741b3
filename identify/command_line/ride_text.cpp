#include "identify/command_line/ride_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"
#include "vehicles/description/gravity.h"
#include "vehicles/requests/engine_text.h"

namespace fourpost {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string Shown(double value, int digits = 3) { return std::isfinite(value) ? Rounded(value, digits) : "-"; }

std::string Millimetres(double metres) { return ShortNumber(1e3 * metres); }
std::string Mm(double metres) { return Shown(1e3 * metres); }
std::string Share(double share) { return share > 0 && share < 1e-5 ? "< 0.001" : Shown(1e2 * share, 2); }

std::string Head(const RideAnswer& ride) {
  if (!ride.by_spectra) return ride.motion + ": time history\n";
  std::string text = ride.motion + ": power spectra";
  if (ride.nonlinear > 0)
    text += ", " + std::to_string(ride.nonlinear) +
            (ride.nonlinear == 1 ? " nonlinear element" : " nonlinear elements") + " by statistical linearisation";
  return text + '\n';
}

std::string ComfortTable(const RideMetrics& metrics) {
  TextTable table({"acceleration, m/s^2", "weighting", "a_w", "rms", "0.5-5 Hz", "5-25 Hz", "MTVV", "VDV, m/s^1.75"});
  for (const RideMetrics::Comfort& comfort : metrics.comfort)
    table.Add({comfort.point, std::string(WeightingName(comfort.weighting)), Shown(comfort.weighted.rms),
               Shown(comfort.rms), Shown(comfort.primary), Shown(comfort.secondary), Shown(comfort.weighted.mtvv),
               Shown(comfort.weighted.vdv)});
  return table.Format();
}

std::string TyreTable(const RideMetrics& metrics) {
  TextTable table({"tyre", "static, kN", "rms, kN", "CPLV, %", "least, kN", "off ground, %"});
  for (const RideMetrics::Wheel& wheel : metrics.wheels)
    table.Add({wheel.tyre, Shown(1e-3 * wheel.static_N), Shown(1e-3 * wheel.rms_N), Shown(1e2 * wheel.Variation()),
               Shown(1e-3 * std::max(0.0, std::round(wheel.least_N))), Share(wheel.off_ground)});
  return table.Format();
}

std::string AxleTable(const RideMetrics& metrics) {
  TextTable table({"axle", "CPLV, %", "ride height, mm rms", "sum of load variances, kN^2"});
  for (const RideMetrics::Axle& axle : metrics.axles)
    table.Add({axle.name, Shown(1e2 * axle.variation), axle.ride_height_rms ? Mm(*axle.ride_height_rms) : "-",
               Shown(1e-6 * axle.load_variance)});
  if (metrics.axles.size() > 1)
    table.Add({"car", Shown(1e2 * metrics.variation), "-", Shown(1e-6 * metrics.load_variance)});
  return table.Format();
}

std::string DamperTable(const RideMetrics& metrics) {
  if (metrics.struts.empty()) return "";
  TextTable table(
      {"damper", "travel, mm rms", "mean, mm", "bump, mm", "rebound, mm", "speed, mm/s rms", "95 %, mm/s", "power, W"});
  for (const RideMetrics::Strut& strut : metrics.struts)
    table.Add({strut.damper, Mm(strut.travel_rms_m), Mm(strut.mean_m), Mm(-strut.least_m), Mm(strut.most_m),
               Mm(strut.speed_rms), Mm(strut.speed_95), Shown(strut.power_W)});
  return table.Format();
}

std::string SpeedTable(const RideMetrics& metrics) {
  if (metrics.struts.empty()) return "";
  std::vector<std::string> head = {"% of time, speed in mm/s"};
  for (std::size_t i = 0; i < kDamperSpeeds.size(); ++i)
    head.push_back((i == 0 ? "0" : Millimetres(kDamperSpeeds[i - 1])) + "-" + Millimetres(kDamperSpeeds[i]));
  head.push_back("more");
  TextTable table(head);
  for (const RideMetrics::Strut& strut : metrics.struts) {
    std::vector<std::string> row = {strut.damper};
    for (const double share : strut.speed_share) row.push_back(Share(share));
    table.Add(row);
  }
  return table.Format();
}

std::string StopTable(const RideMetrics& metrics) {
  if (metrics.stops.empty()) return "";
  TextTable table({"stop", "side", "gap, mm", "remaining, mm", "contact, %"});
  for (const RideMetrics::Stop& stop : metrics.stops)
    table.Add({stop.stop, stop.is_bump ? "bump" : "rebound", Mm(stop.gap_m), Mm(stop.left_m), Share(stop.contact)});
  return table.Format();
}

const BodyGain* GainOf(const RideAnswer& ride, const char* pattern) {
  for (const BodyGain& gain : ride.gains)
    if (gain.pattern == pattern) return &gain;
  return nullptr;
}

std::string At(double value, double frequency_Hz) { return Shown(value) + " at " + Shown(frequency_Hz, 2) + " Hz"; }

/// Gains per millimetre of the posts.
std::string BodyTable(const RideAnswer& ride) {
  if (!ride.metrics.body) return "";
  const RideMetrics::Body& body = *ride.metrics.body;
  TextTable table({"body", "rms", "acceleration rms", "We", "largest gain", "largest acceleration gain"});
  const BodyGain* heave = GainOf(ride, "heave");
  table.Add({"heave", Mm(body.heave_rms) + " mm", Shown(body.heave_acceleration) + " m/s^2", "-",
             heave ? At(heave->largest, heave->at_Hz) + ", mm/mm" : "-",
             heave ? At(1e-3 * heave->largest_acceleration / kGravity, heave->acceleration_at_Hz) + ", g/mm" : "-"});
  const auto turn = [&](const char* name, double rms, double acceleration, double weighted) {
    if (rms == 0) return;
    const BodyGain* gain = GainOf(ride, name);
    table.Add({name, Shown(rms / kDegree) + " deg", Shown(acceleration) + " rad/s^2", Shown(weighted) + " rad/s^2",
               gain ? At(1e-3 * gain->largest / kDegree, gain->at_Hz) + ", deg/mm" : "-",
               gain ? At(1e-3 * gain->largest_acceleration, gain->acceleration_at_Hz) + ", rad/s^2/mm" : "-"});
  };
  turn("pitch", body.pitch_rms, body.pitch_acceleration, body.pitch_weighted);
  turn("roll", body.roll_rms, body.roll_acceleration, body.roll_weighted);
  return table.Format() + "mean heave " + Mm(body.mean_heave) + " mm (dampers' jacking, stops)\n";
}

std::string Foot(const RideAnswer& ride) {
  if (!ride.by_spectra) return EngineText(ride.by);
  return "Peaks and doses are those of normal motion over " + ShortNumber(ride.metrics.duration_s) +
         " s; error of the grid " + Percent(ride.grid_change, 1) + ".\n";
}

}  // namespace

std::string RideText(const RideAnswer& ride) {
  std::string text = Head(ride);
  for (const std::string& table :
       {ComfortTable(ride.metrics), TyreTable(ride.metrics), AxleTable(ride.metrics), DamperTable(ride.metrics),
        SpeedTable(ride.metrics), StopTable(ride.metrics), BodyTable(ride)})
    if (!table.empty()) text += table + '\n';
  return text + Foot(ride);
}

std::string RideDifferenceText(const RideAnswer& spectra, const RideAnswer& history) {
  TextTable table({spectra.motion, "spectra", "time history", "difference, %"});
  const auto add = [&](const std::string& name, double a, double b) {
    if (a > 0 && b > 0) table.Add({name, Shown(a), Shown(b), Shown(1e2 * (a / b - 1), 2)});
  };
  for (std::size_t i = 0; i < spectra.metrics.comfort.size(); ++i)
    add(spectra.metrics.comfort[i].point + " a_w, m/s^2", spectra.metrics.comfort[i].weighted.rms,
        history.metrics.comfort[i].weighted.rms);
  for (std::size_t i = 0; i < spectra.metrics.wheels.size(); ++i)
    add(spectra.metrics.wheels[i].tyre + " CPLV, %", 1e2 * spectra.metrics.wheels[i].Variation(),
        1e2 * history.metrics.wheels[i].Variation());
  for (std::size_t i = 0; i < spectra.metrics.struts.size(); ++i)
    add(spectra.metrics.struts[i].damper + " travel, mm rms", 1e3 * spectra.metrics.struts[i].travel_rms_m,
        1e3 * history.metrics.struts[i].travel_rms_m);
  if (spectra.metrics.body) {
    add("heave, mm rms", 1e3 * spectra.metrics.body->heave_rms, 1e3 * history.metrics.body->heave_rms);
    add("pitch, deg rms", spectra.metrics.body->pitch_rms / kDegree, history.metrics.body->pitch_rms / kDegree);
    add("roll, deg rms", spectra.metrics.body->roll_rms / kDegree, history.metrics.body->roll_rms / kDegree);
  }
  return table.Format();
}

}  // namespace fourpost
