#include "vehicles/requests/pole_files.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "analysis/charts/pole_chart.h"
#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "analysis/text/units.h"
#include "vehicles/condensed/mode_times.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/state_space_json.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;
using Complex = std::complex<double>;

double Hertz(double per_s) { return per_s / (2 * std::numbers::pi); }

Json Pair(const Complex& value) { return {value.real(), value.imag()}; }

Json Pairs(const Eigen::Vector3cd& values) { return {Pair(values.x()), Pair(values.y()), Pair(values.z())}; }

Json ModeJson(const ShapedMode& shaped) {
  const Mode& mode = shaped.mode;
  Json poles = Json::array();
  for (const Complex& pole : PolesOf(mode)) poles.push_back(Pair(pole));
  Json shape = Json::array();
  for (const BodyShape& body : shaped.shape)
    shape.push_back(
        {{"body", body.body}, {"translation_m", Pairs(body.translation)}, {"rotation_rad", Pairs(body.rotation)}});
  Json energy = Json::object();
  for (const MotionShare& part : mode.energy) energy[part.motion] = part.share;
  return {{"name", mode.name},
          {"kind", KindName(mode.kind)},
          {"frequency_Hz", mode.frequency_Hz},
          {"damped_frequency_Hz", Hertz(mode.pole.imag())},
          {"damping_ratio", mode.damping_ratio},
          {"rise_time_s", RiseTime_s(mode)},
          {"settling_time_s", SettlingTime_s(mode)},
          {"poles_per_s", poles},
          {"kinetic_energy", energy},
          {"shape", shape}};
}

Json PathsJson(const Vehicle& vehicle, const PolePaths& traced) {
  Json paths = Json::array();
  for (const PolePath& path : traced.paths) {
    Json poles = Json::array();
    for (const Complex& pole : path.pole) poles.push_back(std::isfinite(pole.real()) ? Pair(pole) : Json());
    paths.push_back({{"mode", path.mode}, {"poles_per_s", poles}});
  }
  const Parameter& parameter = vehicle.parameters[traced.parameter];
  return {{"parameter", parameter.name},
          {"unit", SiUnit(parameter.dimension)},
          {"values", traced.values},
          {"paths", paths}};
}

/// Three digits, in the unit of the file.
std::string Shown(double si, const Parameter& parameter) {
  const double unit = ParseUnit(parameter.unit.empty() ? "1" : parameter.unit)->si;
  const double value = si / unit;
  if (value == 0) return FormatQuantity(0, parameter.unit);
  const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
  const double rounded = step >= 1 ? std::round(value / step) * step : std::round(value / step) / std::round(1 / step);
  return FormatQuantity(rounded * unit, parameter.unit);
}

/// That of the file, where the path goes by.
std::optional<std::size_t> Marked(const Parameter& parameter, const std::vector<double>& values) {
  const auto nearest = std::min_element(values.begin(), values.end(), [&](double a, double b) {
    return std::abs(a - parameter.value) < std::abs(b - parameter.value);
  });
  const double step = values.size() > 1 ? std::abs(values[1] - values[0]) : 0;
  if (std::abs(*nearest - parameter.value) > step / 2) return std::nullopt;
  return static_cast<std::size_t>(nearest - values.begin());
}

}  // namespace

std::string ModesJson(const Vehicle& vehicle, const StateSpace& space, const std::vector<ShapedMode>& modes,
                      const std::vector<PolePaths>& paths, const Diagnostics& findings) {
  Json parameters = Json::object();
  for (const Parameter& parameter : vehicle.parameters) parameters[parameter.name] = parameter.value;
  Json list = Json::array();
  for (const ShapedMode& mode : modes) list.push_back(ModeJson(mode));
  Json traced = Json::array();
  for (const PolePaths& path : paths) traced.push_back(PathsJson(vehicle, path));
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  std::vector<std::string> posts;
  for (const Post& post : vehicle.posts) posts.push_back(post.name);
  const Json json = {{"vehicle", vehicle.name}, {"parameters", parameters},
                     {"modes", list},           {"state_space", StateSpaceJson(vehicle.sensors, posts, space)},
                     {"pole_paths", traced},    {"findings", FindingsJson(findings)},
                     {"versions", versions}};
  return JsonText(json);
}

std::string PolesCsv(const Vehicle& vehicle, const std::vector<PolePaths>& paths) {
  CsvWriter csv({"parameter", "value", "unit", "mode", "real_per_s", "imag_per_s", "frequency_Hz",
                 "damped_frequency_Hz", "damping_ratio"});
  for (const PolePaths& traced : paths) {
    const Parameter& parameter = vehicle.parameters[traced.parameter];
    for (const PolePath& path : traced.paths)
      for (std::size_t i = 0; i < traced.values.size(); ++i) {
        const Complex& pole = path.pole[i];
        if (!std::isfinite(pole.real())) continue;
        csv.Add(parameter.name).Add(traced.values[i]).Add(SiUnit(parameter.dimension)).Add(path.mode);
        csv.Add(pole.real()).Add(pole.imag()).Add(Hertz(std::abs(pole))).Add(Hertz(pole.imag()));
        csv.Add(-pole.real() / std::abs(pole));
      }
  }
  return csv.text();
}

std::string PolesSvg(const Vehicle& vehicle, const PolePaths& paths) {
  const Parameter& parameter = vehicle.parameters[paths.parameter];
  PoleChart chart{.title = "Poles of " + vehicle.name + " over " + parameter.name,
                  .first = Shown(paths.values.front(), parameter),
                  .last = Shown(paths.values.back(), parameter),
                  .marked = Marked(parameter, paths.values)};
  if (chart.marked) chart.marked_value = "next to its value, " + Shown(parameter.value, parameter);
  const auto is_there = [](const Complex& pole) { return std::isfinite(pole.real()); };
  for (const PolePath& path : paths.paths)
    // One point is no path.
    if (paths.values.size() == 1 || std::count_if(path.pole.begin(), path.pole.end(), is_there) > 1)
      chart.curves.push_back({.name = path.mode, .pole = path.pole});
  return PoleSvg(chart);
}

}  // namespace fourpost
