#include "vehicles/requests/kinematics_files.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <nlohmann/json.hpp>

#include "analysis/charts/svg_chart.h"
#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDeg = 180 / std::numbers::pi;
constexpr double kMm = 1000;

Json OptionalNumber(const std::optional<double>& value) { return value ? Json(*value) : Json(); }
double OrNan(const std::optional<double>& value) { return value.value_or(std::numeric_limits<double>::quiet_NaN()); }

Json Triple(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

const std::string& WheelNamed(const Suspension& suspension, const AxleKinematics& kinematics, std::size_t k) {
  return suspension.wheels[suspension.axles[kinematics.axle].wheels[k]].name;
}

const char* CaseName(const AxleCompliance& compliance) { return compliance.is_opposed ? "opposed" : "together"; }

const char* TravelKind(const AxleTravel& travel) {
  switch (travel.kind) {
    case AxleTravel::Kind::kHeave: return "heave";
    case AxleTravel::Kind::kRoll: return "roll";
    case AxleTravel::Kind::kWheel: return "wheel";
  }
  return "";
}

Json StationJson(const AxleStation& station) {
  Json wheels = Json::array();
  for (const WheelStation& wheel : station.wheels)
    wheels.push_back({{"rise_m", wheel.rise},
                      {"camber_rad", wheel.place.camber},
                      {"toe_rad", wheel.place.toe},
                      {"steer_rad", wheel.place.steer},
                      {"centre_m", Triple(wheel.place.centre)},
                      {"foot_m", Triple(wheel.place.foot)},
                      {"camber_rad_per_m", wheel.rate.camber},
                      {"toe_rad_per_m", wheel.rate.toe},
                      {"steer_rad_per_m", wheel.rate.steer},
                      {"centre_m_per_m", Triple(wheel.rate.centre)},
                      {"foot_m_per_m", Triple(wheel.rate.foot)},
                      {"load_N", wheel.load}});
  return {{"travel_m", station.travel},
          {"roll_rad", station.roll},
          {"roll_rad_per_m", station.roll_rate},
          {"track_m", OptionalNumber(station.track)},
          {"wheelbase_m", OptionalNumber(station.wheelbase)},
          {"roll_centre_height_m", OptionalNumber(station.roll_centre)},
          {"wheels", wheels},
          {"strut_lengths_m", station.lengths},
          {"motion_ratios", station.ratios}};
}

Json AxleJson(const Suspension& suspension, const AxleKinematics& kinematics) {
  Json wheels = Json::array();
  for (const std::size_t i : suspension.axles[kinematics.axle].wheels) wheels.push_back(suspension.wheels[i].name);
  Json struts = Json::array();
  for (const AxleStrut& strut : kinematics.struts)
    struts.push_back({{"name", strut.name}, {"kind", KindName(strut.kind)}});
  Json travels = Json::array();
  for (const AxleTravel& travel : kinematics.travels) {
    Json positions = Json::array();
    for (const AxleStation& station : travel.stations) positions.push_back(StationJson(station));
    travels.push_back({{"name", travel.name},
                       {"kind", TravelKind(travel)},
                       {"asked_m", {travel.lower, travel.upper}},
                       {"reached_m", {travel.reached_lower, travel.reached_upper}},
                       {"positions", positions}});
  }
  Json compliance = Json::array();
  for (const AxleCompliance& answer : kinematics.compliance) {
    Json changes = Json::array();
    for (const WheelPlace& wheel : answer.wheels)
      changes.push_back({{"steer_rad", wheel.steer},
                         {"toe_rad", wheel.toe},
                         {"camber_rad", wheel.camber},
                         {"centre_m", Triple(wheel.centre)},
                         {"foot_m", Triple(wheel.foot)}});
    compliance.push_back({{"load", LoadName(answer.load)}, {"case", CaseName(answer)}, {"wheels", changes}});
  }
  return {{"name", suspension.axles[kinematics.axle].name},
          {"wheels", wheels},
          {"struts", struts},
          {"stops_m", {OptionalNumber(kinematics.stop_lower), OptionalNumber(kinematics.stop_upper)}},
          {"travels", travels},
          {"compliance", compliance}};
}

// The picture.

constexpr const char* kLeftColor = "#0072B2";
constexpr const char* kRightColor = "#D55E00";

using Reading = std::function<double(const AxleStation&)>;

SvgSeries SeriesOf(const AxleTravel& travel, const SvgStyle& style, const Reading& reading) {
  SvgSeries series{.style = style, .x = {}, .y = {}};
  for (const AxleStation& station : travel.stations) {
    series.x.push_back(kMm * station.travel);
    series.y.push_back(reading(station));
  }
  return series;
}

SvgPanel PanelOf(const AxleTravel& travel, std::vector<SvgSeries> series, double least_range) {
  SvgPanel panel;
  panel.x = LinearAxis(kMm * travel.stations.front().travel, kMm * travel.stations.back().travel, 6);
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  for (const SvgSeries& one : series)
    for (const double y : one.y)
      if (std::isfinite(y)) {
        lower = std::min(lower, y);
        upper = std::max(upper, y);
      }
  // What changes by less is a line in the middle.
  if (!(upper - lower > least_range)) {
    const double middle = std::isfinite(lower) ? (lower + upper) / 2 : 0;
    lower = middle - least_range;
    upper = middle + least_range;
  }
  panel.y = LinearAxis(lower, upper, 5);
  panel.series = std::move(series);
  return panel;
}

SvgStyle StyleOf(const Suspension& suspension, const AxleKinematics& kinematics, std::size_t k) {
  const Wheel& wheel = suspension.wheels[suspension.axles[kinematics.axle].wheels[k]];
  // The left one shows beside a right one that lies on it.
  return {.label = wheel.name, .color = wheel.side < 0 ? kRightColor : kLeftColor, .width = wheel.side < 0 ? 1.2 : 3};
}

std::vector<SvgSeries> OfWheels(const Suspension& suspension, const AxleKinematics& kinematics,
                                const AxleTravel& travel, const std::function<double(const WheelStation&)>& reading) {
  std::vector<SvgSeries> all;
  for (std::size_t k = 0; k < travel.stations.front().wheels.size(); ++k)
    all.push_back(SeriesOf(travel, StyleOf(suspension, kinematics, k),
                           [&](const AxleStation& station) { return reading(station.wheels[k]); }));
  return all;
}

/// Colours of struts, by kind.
SvgStyle StyleOf(AxleStrut::Kind kind) {
  switch (kind) {
    case AxleStrut::Kind::kSpring: return {.label = "spring", .color = "#009E73", .width = 3};
    case AxleStrut::Kind::kDamper: return {.label = "damper", .color = "#CC79A7", .width = 1.8};
    default: return {.label = "anti-roll bar", .color = "#E69F00", .width = 1.8};
  }
}

bool IsDrawn(const AxleStrut& strut) {
  return strut.kind == AxleStrut::Kind::kSpring || strut.kind == AxleStrut::Kind::kDamper ||
         strut.kind == AxleStrut::Kind::kAntiRollBar;
}

/// Below what a picture shows.
constexpr double kUnmovedRatio = 1e-4;

std::vector<SvgSeries> OfRatios(const AxleKinematics& kinematics, const AxleTravel& travel) {
  std::vector<SvgSeries> all;
  for (std::size_t i = 0; i < kinematics.struts.size(); ++i)
    if (IsDrawn(kinematics.struts[i]) && std::abs(travel.Design().ratios[i]) > kUnmovedRatio)
      all.push_back(SeriesOf(travel, StyleOf(kinematics.struts[i].kind),
                             [i](const AxleStation& station) { return station.ratios[i]; }));
  return all;
}

SvgRow RowOf(const Suspension& suspension, const AxleKinematics& kinematics, const AxleTravel& travel) {
  constexpr double kAngle_deg = 0.02;
  constexpr double kLoad_kN = 0.02;
  constexpr double kRatio = 0.005;
  const auto wheels = [&](const std::function<double(const WheelStation&)>& reading, double least) {
    return PanelOf(travel, OfWheels(suspension, kinematics, travel, reading), least);
  };
  SvgRow row{
      .title = travel.name + (travel.kind == AxleTravel::Kind::kWheel ? " alone" : ""), .note = "", .panels = {}};
  row.panels.push_back(wheels([](const WheelStation& wheel) { return kDeg * wheel.place.camber; }, kAngle_deg));
  row.panels.push_back(wheels([](const WheelStation& wheel) { return kDeg * wheel.place.toe; }, kAngle_deg));
  row.panels.push_back(wheels([](const WheelStation& wheel) { return wheel.load / 1000; }, kLoad_kN));
  row.panels.push_back(PanelOf(travel, OfRatios(kinematics, travel), kRatio));
  return row;
}

/// What an axle has in heave besides its wheels' angles.
SvgRow AxleRow(const Suspension& suspension, const AxleKinematics& kinematics, const AxleTravel& heave) {
  constexpr double kLength_mm = 1;
  const SvgStyle style{.label = "axle", .color = "#000000", .width = 1.8};
  SvgRow row;
  const auto add = [&](const char* title, const Reading& reading) {
    SvgPanel panel = PanelOf(heave, {SeriesOf(heave, style, reading)}, kLength_mm);
    panel.title = title;
    row.panels.push_back(std::move(panel));
  };
  const AxleStation& design = heave.Design();
  if (design.track) add("heave: track [mm]", [](const AxleStation& station) { return kMm * OrNan(station.track); });
  if (design.roll_centre)
    add("roll centre [mm]", [](const AxleStation& station) { return kMm * OrNan(station.roll_centre); });
  if (design.wheelbase)
    add("wheelbase [mm]", [](const AxleStation& station) { return kMm * OrNan(station.wheelbase); });
  std::vector<SvgSeries> forward =
      OfWheels(suspension, kinematics, heave, [](const WheelStation& wheel) { return kMm * wheel.place.centre.x(); });
  for (std::size_t k = 0; k < forward.size(); ++k)
    for (double& x : forward[k].y) x -= kMm * design.wheels[k].place.centre.x();
  SvgPanel fore_aft = PanelOf(heave, std::move(forward), kLength_mm);
  fore_aft.title = "wheel centre forward [mm]";
  row.panels.push_back(std::move(fore_aft));
  return row;
}

}  // namespace

std::string KinematicsJson(const Vehicle& vehicle, const Suspension& suspension,
                           const std::vector<AxleKinematics>& axles, const Diagnostics& findings) {
  Json list = Json::array();
  for (const AxleKinematics& kinematics : axles) list.push_back(AxleJson(suspension, kinematics));
  Json parameters = Json::object();
  for (const Parameter& parameter : vehicle.parameters) parameters[parameter.name] = parameter.value;
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  const Json json = {{"vehicle", vehicle.name},
                     {"parameters", parameters},
                     {"axles", list},
                     {"findings", FindingsJson(findings)},
                     {"versions", versions}};
  return JsonText(json);
}

std::string WheelsCsv(const Suspension& suspension, const std::vector<AxleKinematics>& axles) {
  CsvWriter csv({"axle", "travel", "travel_mm", "roll_deg", "wheel", "rise_mm", "camber_deg", "toe_deg", "steer_deg",
                 "centre_x_mm", "centre_y_mm", "centre_z_mm", "foot_x_mm", "foot_y_mm", "load_N", "track_mm",
                 "wheelbase_mm", "roll_centre_mm"});
  for (const AxleKinematics& kinematics : axles)
    for (const AxleTravel& travel : kinematics.travels)
      for (const AxleStation& station : travel.stations)
        for (std::size_t k = 0; k < station.wheels.size(); ++k) {
          const WheelStation& wheel = station.wheels[k];
          csv.Add(suspension.axles[kinematics.axle].name).Add(travel.name).Add(kMm * station.travel);
          csv.Add(kDeg * station.roll).Add(WheelNamed(suspension, kinematics, k)).Add(kMm * wheel.rise);
          csv.Add(kDeg * wheel.place.camber).Add(kDeg * wheel.place.toe).Add(kDeg * wheel.place.steer);
          for (Eigen::Index i = 0; i < 3; ++i) csv.Add(kMm * wheel.place.centre[i]);
          for (Eigen::Index i = 0; i < 2; ++i) csv.Add(kMm * wheel.place.foot[i]);
          csv.Add(wheel.load).Add(kMm * OrNan(station.track)).Add(kMm * OrNan(station.wheelbase));
          csv.Add(kMm * OrNan(station.roll_centre));
        }
  return csv.text();
}

std::string RatiosCsv(const Suspension& suspension, const std::vector<AxleKinematics>& axles) {
  CsvWriter csv({"axle", "travel", "travel_mm", "strut", "kind", "length_mm", "motion_ratio"});
  for (const AxleKinematics& kinematics : axles)
    for (const AxleTravel& travel : kinematics.travels)
      for (const AxleStation& station : travel.stations)
        for (std::size_t i = 0; i < kinematics.struts.size(); ++i) {
          csv.Add(suspension.axles[kinematics.axle].name).Add(travel.name).Add(kMm * station.travel);
          csv.Add(kinematics.struts[i].name).Add(KindName(kinematics.struts[i].kind));
          csv.Add(kMm * station.lengths[i]).Add(station.ratios[i]);
        }
  return csv.text();
}

std::string ComplianceCsv(const Suspension& suspension, const std::vector<AxleKinematics>& axles) {
  CsvWriter csv(
      {"axle", "load", "per", "case", "wheel", "steer_deg", "toe_deg", "camber_deg", "centre_x_mm", "centre_y_mm"});
  for (const AxleKinematics& kinematics : axles)
    for (const AxleCompliance& answer : kinematics.compliance) {
      const bool is_torque = answer.load == WheelLoad::kAligning;
      const double size = is_torque ? 100 : 1000;
      for (std::size_t k = 0; k < answer.wheels.size(); ++k) {
        const WheelPlace& wheel = answer.wheels[k];
        csv.Add(suspension.axles[kinematics.axle].name).Add(LoadName(answer.load));
        csv.Add(is_torque ? "100 N*m" : "1 kN").Add(CaseName(answer)).Add(WheelNamed(suspension, kinematics, k));
        csv.Add(size * kDeg * wheel.steer).Add(size * kDeg * wheel.toe).Add(size * kDeg * wheel.camber);
        csv.Add(size * kMm * wheel.centre.x()).Add(size * kMm * wheel.centre.y());
      }
    }
  return csv.text();
}

std::string KinematicsSvg(const Vehicle& vehicle, const Suspension& suspension, const AxleKinematics& kinematics) {
  SvgSheet sheet{.title = "Kinematics of " + vehicle.name + ", axle '" + suspension.axles[kinematics.axle].name + "'",
                 .note =
                     "chassis held, the other wheels at the height of the design pose; roll: the right wheel rises "
                     "as the left one falls",
                 .legend = {},
                 .columns = {"camber [deg]", "toe-in [deg]", "load [kN]", "motion ratio"},
                 .x_label = "travel [mm]",
                 .rows = {}};
  for (std::size_t k = 0; k < suspension.axles[kinematics.axle].wheels.size(); ++k)
    sheet.legend.push_back(StyleOf(suspension, kinematics, k));
  for (const AxleStrut::Kind kind : {AxleStrut::Kind::kSpring, AxleStrut::Kind::kDamper, AxleStrut::Kind::kAntiRollBar})
    if (std::any_of(kinematics.struts.begin(), kinematics.struts.end(),
                    [&](const AxleStrut& strut) { return strut.kind == kind; }))
      sheet.legend.push_back(StyleOf(kind));
  for (const AxleTravel& travel : kinematics.travels) {
    sheet.rows.push_back(RowOf(suspension, kinematics, travel));
    if (travel.kind == AxleTravel::Kind::kHeave) sheet.rows.push_back(AxleRow(suspension, kinematics, travel));
  }
  return SvgText(sheet);
}

}  // namespace fourpost
