#include "vehicles/lint/table_lint.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "vehicles/description/element_list.h"
#include "vehicles/lint/findings.h"

namespace fourpost {
namespace {

/// x and y of a point.
using Pair = std::pair<double, double>;

double Between(const Pair& a, const Pair& b, double x) {
  return a.second + (b.second - a.second) * (x - a.first) / (b.first - a.first);
}

/// On the straight line between the points beside it; nothing beyond them, or at one of them.
std::optional<double> ForceAtRest(const std::vector<Pair>& points) {
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i - 1].first < 0 && points[i].first > 0) return Between(points[i - 1], points[i], 0);
  return std::nullopt;
}

/// Where straight lines between the points reach a force; nothing beyond them.
std::optional<double> PlaceOf(double force, const std::vector<Pair>& points) {
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i - 1].second <= force && force <= points[i].second)
      return Between({points[i - 1].second, points[i - 1].first}, {points[i].second, points[i].first}, force);
  return std::nullopt;
}

double LargestForce(const std::vector<Pair>& points) {
  double largest = 0;
  for (const auto& [at, force] : points) largest = std::max(largest, std::abs(force));
  return largest;
}

std::string Millimetres(double metres) { return Readable(std::round(metres * 1e4) * 1e-4 + 0.0, "m", "mm"); }

}  // namespace

void LintDamperTables(const DrawnVehicle& drawn, FileFaults& findings) {
  // Of the largest force: what a bench's zero drifts by, and less than a gas force.
  constexpr double kTrifle = 0.01;
  for (const Damper& damper : drawn.vehicle.dampers) {
    std::vector<Pair> points;
    for (const DashpotDescription::TablePoint& point : damper.law.table)
      points.emplace_back(drawn.At(point.speed), drawn.At(point.force));
    const std::optional<double> force = ForceAtRest(points);
    if (force && std::abs(*force) > kTrifle * LargestForce(points))
      findings.Report(
          kTableAtRest, damper.source_line,
          {Called("fp:damper", damper.name), Readable(*force, "N"), *force < 0 ? " and state it by <gas>" : ""});
  }
}

void LintTyreTables(const LintSubject& subject, FileFaults& findings) {
  for (std::size_t i = 0; i < subject.vehicle.tyres.size(); ++i) {
    const Tyre& tyre = subject.vehicle.tyres[i];
    if (tyre.law.table.empty()) continue;
    const double least = subject.At(tyre.law.table.front().force);
    const double greatest = subject.At(tyre.law.table.back().force);
    const double load = subject.model.preloads.tyre[i];
    if (least <= load && load <= greatest) continue;
    findings.Report(kTyreTableEnd, tyre.source_line,
                    {Called("fp:tyre", tyre.name), Readable(load, "N"), Readable(least, "N"), Readable(greatest, "N")});
  }
}

void LintSpringTables(const LintSubject& subject, FileFaults& findings) {
  // Of what it carries: a curve fits no coil better.
  constexpr double kAlike = 0.1;
  for (std::size_t i = 0; i < subject.vehicle.springs.size(); ++i) {
    const Spring& spring = subject.vehicle.springs[i];
    if (spring.law.table.empty() || spring.law.is_placed) continue;
    std::vector<Pair> points;
    for (const SpringDescription::TablePoint& point : spring.law.table)
      points.emplace_back(subject.At(point.extension), subject.At(point.force));
    const double carried = subject.model.preloads.spring[i];
    const std::optional<double> there = PlaceOf(carried, points);
    if (there && std::abs(*there) <= kAlike * (points.back().first - points.front().first)) continue;
    findings.Report(
        kTableNotPlaced, spring.source_line,
        {spring.Element(), Readable(carried, "N"), there ? ", \"" + Millimetres(*there) + "\" by this load" : ""});
  }
}

}  // namespace fourpost
