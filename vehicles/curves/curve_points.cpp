#include "vehicles/curves/curve_points.h"

#include <algorithm>
#include <cmath>

#include "analysis/text/short_number.h"
#include "analysis/text/units.h"
#include "vehicles/curves/curve_limits.h"
#include "vehicles/curves/findings.h"

namespace fourpost {
namespace {

/// As of numbers in a vehicle file.
constexpr double kLargest = 1e30;

std::string Shown(double si, const std::string& unit) { return FormatQuantity(AtDigits(si, 6), unit); }

}  // namespace

bool OrderPoints(const std::string& file, const CurveNames& names, std::vector<CurvePoint>& points,
                 Diagnostics& diagnostics) {
  if (points.size() < 2) {
    diagnostics.Report(kCurvePoints, {file, points.empty() ? 0 : points.front().line});
    return false;
  }
  if (points.size() > kMostCurvePoints) {
    diagnostics.Report(kCurveTooLong, {file, points[kMostCurvePoints].line},
                       {std::to_string(points.size()), std::to_string(kMostCurvePoints)});
    return false;
  }
  bool is_good = true;
  const auto is_full = [&] { return HasManyFaults(diagnostics); };
  const auto shown = [&](const CurvePoint& point) { return Shown(point.x, names.x_unit); };
  const auto force = [&](const CurvePoint& point) { return Shown(point.force, names.force_unit); };
  for (std::size_t i = 0; i < points.size() && !is_full(); ++i) {
    const CurvePoint& point = points[i];
    if (std::abs(point.x) <= kLargest && std::abs(point.force) <= kLargest) continue;
    diagnostics.Report(kCurveTooLarge, {file, point.line}, {shown(point), force(point)});
    is_good = false;
  }
  if (points.front().x > points.back().x) std::reverse(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size() && !is_full(); ++i) {
    if (points[i - 1].x < points[i].x && points[i - 1].force < points[i].force) continue;
    diagnostics.Report(kCurveOrder, {file, points[i].line},
                       {shown(points[i]), force(points[i]), shown(points[i - 1]), force(points[i - 1]), names.x});
    is_good = false;
  }
  return is_good && !is_full();
}

bool CheckResistance(const std::string& file, const CurveNames& names, const std::vector<CurvePoint>& points,
                     Diagnostics& diagnostics) {
  const auto pushes = [](const CurvePoint& point) {
    return point.x * point.force < 0 || (point.x != 0 && point.force == 0);
  };
  const auto moves = [](const CurvePoint& point) { return point.x != 0; };
  const auto pushing = std::count_if(points.begin(), points.end(), pushes);
  if (pushing > 1 && pushing == std::count_if(points.begin(), points.end(), moves)) {
    diagnostics.Report(kCurvePushesAlways, {file, points.front().line});
    return false;
  }
  bool is_good = true;
  for (const CurvePoint& point : points) {
    if (HasManyFaults(diagnostics)) return false;
    const bool has_preload = point.x == 0 && point.force != 0;
    if (has_preload) diagnostics.Report(kCurveAtRest, {file, point.line}, {Shown(point.force, names.force_unit)});
    else if (pushes(point))
      diagnostics.Report(kCurvePushes, {file, point.line},
                         {Shown(point.x, names.x_unit), Shown(point.force, names.force_unit)});
    is_good = is_good && !has_preload && !pushes(point);
  }
  return is_good;
}

}  // namespace fourpost
