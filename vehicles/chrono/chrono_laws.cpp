#include "vehicles/chrono/chrono_laws.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "vehicles/chrono/findings.h"
#include "vehicles/laws/monotone_curve.h"

namespace fourpost {
namespace {

/// To a tenth of a micrometre, a micronewton, a tenth of a micrometre per second.
std::string InMm(double metres) { return FormatNumber(std::round(metres * 1e7) + 0.0, -4) + " mm"; }
std::string InN(double newtons) { return FormatNumber(std::round(newtons * 1e6) + 0.0, -6) + " N"; }
std::string InMps(double speed) { return FormatNumber(std::round(speed * 1e7) + 0.0, -7) + " m/s"; }

ParameterText Rate(const std::string& name, double value, const char* unit, double precision,
                   const std::string& source) {
  return {.name = name,
          .value = value,
          .lower = 0.5 * value,
          .upper = 2 * value,
          .precision = precision,
          .unit = unit,
          .source = source};
}

ParameterText Scale(const std::string& name, const std::string& source) {
  return {.name = name, .value = 1, .lower = 0.5, .upper = 2, .precision = 0.001, .unit = "", .source = source};
}

std::string Points(const std::vector<std::pair<double, double>>& points, const char* x, std::string (*shown)(double)) {
  std::string text;
  for (const auto& [at, force] : points)
    text += "\n      <point " + std::string(x) + "=\"" + shown(at) + "\" force=\"" + InN(force) + "\"/>";
  return text + "\n    </table>";
}

/// Rows of two numbers in rising order; Rises() refuses two at one place.
std::vector<std::pair<double, double>> Sorted(const std::vector<std::vector<double>>& rows) {
  std::vector<std::pair<double, double>> points;
  for (const std::vector<double>& row : rows) points.emplace_back(row[0], row[1]);
  std::sort(points.begin(), points.end());
  return points;
}

bool Rises(const std::vector<std::pair<double, double>>& points) {
  if (points.size() < 2) return false;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i - 1].first < points[i].first) || !(points[i - 1].second < points[i].second)) return false;
  return true;
}

KnownLaw SpringCurve(const ChronoNode& spring, const std::string& axle, double length, const std::string& source) {
  const std::vector<std::pair<double, double>> points = Sorted(spring.Rows("Spring Curve Data", 2));
  const double free_length = spring.Number("Free Length");
  if (!Rises(points)) {
    spring.ReportAt("Spring Curve Data", kChronoValue,
                    {spring.Called("Spring Curve Data"), "a curve of two points at least whose force rises"});
    return {};
  }
  std::vector<double> x;
  std::vector<double> force;
  for (const auto& [at, value] : points) {
    x.push_back(at);
    force.push_back(value);
  }
  const double at = length - free_length;
  const double tension = MonotoneCurve(x, force).Value(at) - spring.MaybeNumber("Preload").value_or(0);
  const std::string head = "<table at=\"" + InMm(at) + "\" scale=\"$s_" + axle + "_spring\"";
  const std::string tail = ">" + Points(points, "extension", InMm);
  return {.tags = head + tail,
          .loaded = head + " preload=\"" + InN(tension) + "\"" + tail,
          .parameters = {Scale("s_" + axle + "_spring", source + ": its curve")}};
}

/// The forces of a map at one length, in its nearest column.
std::vector<std::vector<double>> MapAt(const ChronoNode& shock, double length) {
  const std::vector<double> lengths = shock.Numbers("Deformation");
  std::vector<std::vector<double>> rows = shock.Rows("Map Data", 0);
  if (lengths.empty()) return {};
  const double rest = shock.MaybeNumber("Free Length").value_or(0);
  const auto nearest = std::min_element(lengths.begin(), lengths.end(), [&](double a, double b) {
    return std::abs(a + rest - length) < std::abs(b + rest - length);
  });
  const auto column = static_cast<std::size_t>(nearest - lengths.begin()) + 1;
  std::vector<std::vector<double>> points;
  for (const std::vector<double>& row : rows) {
    if (row.size() <= column) {
      shock.ReportAt("Map Data", kChronoValue,
                     {shock.Called("Map Data"), "rows of a speed and a force for each deformation"});
      return {};
    }
    points.push_back({row[0], row[column]});
  }
  shock.ReportAt("Map Data", kChronoMap, {shock.Called(), InMm(std::round(length * 1e4) * 1e-4)});
  return points;
}

KnownLaw ShockCurve(const ChronoNode& shock, std::string_view name, const std::vector<std::vector<double>>& rows,
                    const std::string& axle, const std::string& source) {
  if (rows.empty()) return {};
  const std::vector<std::pair<double, double>> points = Sorted(rows);
  const bool resists = std::all_of(points.begin(), points.end(), [](const std::pair<double, double>& point) {
    return point.first == 0 ? point.second == 0 : point.first * point.second > 0;
  });
  if (!Rises(points) || !resists) {
    shock.ReportAt(name, kChronoValue,
                   {shock.Called(name), "a curve of two points at least whose force rises, against the motion"});
    return {};
  }
  const std::string scale = "s_" + axle + "_damper";
  return {.tags = "<table scale=\"$" + scale + "\">" + Points(points, "speed", InMps),
          .parameters = {Scale(scale, source + ": its curve")}};
}

/// d of -c v / (1 + d |v|) in bump and rebound.
struct Degressivity {
  double bump = 0;
  double rebound = 0;

  /// At |v| = 1 / d the force is half of c v: beyond 1000 m/s that is no levelling off.
  static bool LevelsOff(double d) { return d > 1e-3; }
};

/// Zero where it is not stated; nothing, reported, of a force that would rise beyond all bounds.
std::optional<Degressivity> DegressivityOf(const ChronoNode& shock) {
  constexpr const char* kBump = "Degressivity Compression";
  constexpr const char* kRebound = "Degressivity Expansion";
  Degressivity d;
  if (!shock.Has(kBump) || !shock.Has(kRebound)) return d;
  d = {shock.Number(kBump), shock.Number(kRebound)};
  for (const auto& [name, value] : {std::pair(kBump, d.bump), std::pair(kRebound, d.rebound)})
    if (value < 0) shock.ReportAt(name, kChronoValue, {shock.Called(name), "zero or above"});
  if (d.bump < 0 || d.rebound < 0) return std::nullopt;
  return d;
}

/// Of a shock that levels off one way only, which no law with rates states: points of its curve.
KnownLaw HalfDegressive(double rate, const Degressivity& d, const std::string& axle, const std::string& source) {
  std::vector<std::pair<double, double>> points;
  for (const double speed : {-2.0, -1.0, -0.5, -0.2, -0.1, -0.05, 0.0, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0})
    points.emplace_back(speed, rate * speed / (1 + (speed < 0 ? d.bump : d.rebound) * std::abs(speed)));
  const std::string scale = "s_" + axle + "_damper";
  return {.tags = "<table scale=\"$" + scale + "\">" + Points(points, "speed", InMps),
          .parameters = {Scale(scale, source + ": its degressive law")}};
}

}  // namespace

KnownLaw ChronoSpring(const ChronoNode& spring, const std::string& axle, double length, const std::string& source) {
  if (spring.IsNull()) return {};
  for (const char* second : {"Damping Coefficient", "Damping Curve Data"})
    if (spring.Has(second)) spring.ReportAt(second, kChronoSecondLaw, {spring.Called(second), spring.Called()});
  if (spring.Has("Spring Curve Data")) return SpringCurve(spring, axle, length, source);
  if (!spring.Has("Spring Coefficient")) {
    spring.Report(kChronoLaw, {spring.Called()});
    return {};
  }
  const double rate = spring.Number("Spring Coefficient");
  const double free_length = spring.Number("Free Length");
  if (!(rate > 0)) {
    spring.ReportAt("Spring Coefficient", kChronoValue, {spring.Called("Spring Coefficient"), "above zero"});
    return {};
  }
  const std::string name = "k_" + axle;
  const double preload = spring.MaybeNumber("Preload").value_or(0) - rate * (length - free_length);
  return {.tags = "<linear stiffness=\"$" + name + "\"/>",
          .loaded = "<linear stiffness=\"$" + name + "\" preload=\"" + InN(-preload) + "\"/>",
          .parameters = {Rate(name, std::round(rate * 1e3) * 1e-6, "N/mm", 0.01, source + ": one spring")}};
}

KnownLaw ChronoShock(const ChronoNode& shock, const std::string& axle, double length, const std::string& source) {
  if (shock.IsNull()) return {};
  if (shock.Has("Map Data")) return ShockCurve(shock, "Map Data", MapAt(shock, length), axle, source);
  if (shock.Has("Damping Curve Data"))
    return ShockCurve(shock, "Damping Curve Data", shock.Rows("Damping Curve Data", 2), axle, source);
  if (!shock.Has("Damping Coefficient")) {
    shock.Report(kChronoLaw, {shock.Called()});
    return {};
  }
  const double rate = shock.Number("Damping Coefficient");
  if (!(rate > 0)) {
    shock.ReportAt("Damping Coefficient", kChronoValue, {shock.Called("Damping Coefficient"), "above zero"});
    return {};
  }
  const std::optional<Degressivity> d = DegressivityOf(shock);
  if (!d) return {};
  const bool levels_off = Degressivity::LevelsOff(d->bump);
  if (levels_off != Degressivity::LevelsOff(d->rebound)) return HalfDegressive(rate, *d, axle, source);
  const std::string bump = "c_" + axle + "_bump";
  const std::string rebound = "c_" + axle + "_rebound";
  const std::string rates = " bump=\"$" + bump + "\" rebound=\"$" + rebound + "\"";
  const double c = std::round(rate * 1e3) * 1e-3;
  KnownLaw law{.tags = "<bilinear" + rates + "/>",
               .parameters = {Rate(bump, c, "N*s/m", 1, source + ": one shock, both directions alike"),
                              Rate(rebound, c, "N*s/m", 1, source + ": one shock, both directions alike")}};
  if (levels_off)
    law.tags = "<saturating" + rates + " bump_speed=\"" + InMps(1 / d->bump) + "\" rebound_speed=\"" +
               InMps(1 / d->rebound) + "\"/>";
  return law;
}

std::optional<KnownLaw> ChronoStops(const ChronoNode& spring, double length) {
  if (!spring.Has("Minimum Length") || !spring.Has("Maximum Length")) return std::nullopt;
  const auto gap = [&](const char* name, double sign) {
    const double room = sign * (spring.Number(name) - length);
    if (room < 0)
      spring.ReportAt(name, kChronoStopClosed,
                      {spring.Called(), InMm(std::round(length * 1e4) * 1e-4), InMm(spring.Number(name))});
    return InMm(std::max(room, 0.0));
  };
  const std::string law = "\" stiffness=\"100 N/mm\" cubic=\"0.06 N/mm^3\"/>";
  return KnownLaw{.tags = "<bump gap=\"" + gap("Minimum Length", -1) + law + "\n    <rebound gap=\"" +
                          gap("Maximum Length", 1) + law};
}

}  // namespace fourpost
