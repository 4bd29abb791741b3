#include "vehicles/templates/axle_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "vehicles/templates/findings.h"

namespace fourpost {
namespace {

constexpr std::array<std::string_view, 2> kAxles = {"front", "rear"};
/// Of the plausible car [m].
constexpr double kWheelbase = 2.6;
/// No drawing has such numbers [m]; millimetres that were meant as metres are fewer.
constexpr double kFar = 1e5;
/// Below it two points are one [m].
constexpr double kNoLength = 1e-3;
/// Of the links that hold a beam axle sideways, in plan [rad]: ten degrees; cars have 20 to 45.
constexpr double kLeastConvergence = 0.175;
/// What a drawing leaves beside the plane of symmetry [m].
constexpr double kMiddle = 1e-3;

std::string Millimetres(double metres) { return FormatNumber(std::round(metres * 1e6) + 0.0, -3) + " mm"; }

std::vector<std::string> KindNames() {
  std::vector<std::string> names;
  for (const SuspensionKind& kind : SuspensionKinds()) names.emplace_back(kind.name);
  return names;
}

/// The faults of one car's points.
class PointCheck {
 public:
  PointCheck(CarPoints& car, std::string file, Diagnostics& diagnostics)
      : car_(car), file_(std::move(file)), diagnostics_(diagnostics) {}

  void Sort(const HardPoint& point) {
    const auto axle = std::find(kAxles.begin(), kAxles.end(), point.axle);
    if (axle == kAxles.end()) return Report(point, kSuspensionAxle, {point.axle});
    AxlePoints& points = car_[static_cast<std::size_t>(axle - kAxles.begin())];
    const PointSpec* const spec = points.kind->Find(point.name);
    if (!spec) return ReportUnknown(point, *points.kind);
    if (const auto found = points.points.find(point.name); found != points.points.end())
      return Report(point, kPointTwice, {point.axle, point.name, std::to_string(found->second.line)});
    CheckCarrier(point, *spec, *points.kind);
    CheckSide(point, *spec);
    HardPoint& kept = points.points.emplace(point.name, point).first->second;
    if (point.xyz.lpNorm<Eigen::Infinity>() > kFar) {
      Report(point, kPointFar, {point.axle, point.name, FormatNumber(std::round(point.xyz.norm())) + " m"});
      kept.xyz.setConstant(NAN);
    }
  }

  void CheckAxle(const AxlePoints& axle) {
    for (const PointSpec& spec : axle.kind->points) {
      CheckThere(axle, spec);
      if (!IsKnown(axle, spec.name) || !IsKnown(axle, spec.partner)) continue;
      const double length = (axle.At(spec.name) - axle.At(spec.partner)).norm();
      const bool is_second = spec.need == PointSpec::Need::kOptional && spec.name > spec.partner;
      if (length < kNoLength && !is_second)
        Report(PointOf(axle, spec.name), kLinkWithoutLength,
               {axle.axle, std::string(spec.name), std::string(spec.partner), Millimetres(length)});
    }
    for (const ArmSpec& arm : axle.kind->arms) CheckArm(axle, arm);
    if (axle.kind->name == "four_link") CheckConvergence(axle);
    if (IsKnown(axle, "wheel_axis") && IsKnown(axle, "wheel_centre")) {
      const double outward = axle.At("wheel_axis").y() - axle.At("wheel_centre").y();
      if (outward < 0) Report(PointOf(axle, "wheel_axis"), kWheelAxisInboard, {axle.axle, Millimetres(-outward)});
    }
    if (!IsKnown(axle, "wheel_centre") || !IsKnown(axle, "contact")) return;
    const double height = axle.At("wheel_centre").z() - axle.At("contact").z();
    if (!(height > 0.1 && height < 1.5))
      Report(PointOf(axle, "contact"), kTyreSize, {axle.axle, Millimetres(height), "z"});
    else CheckContact(axle);
  }

  /// Its height alone is used.
  void CheckContact(const AxlePoints& axle) {
    // Drawings often have it below the centre of a wheel with a degree of camber.
    constexpr double kUsual = 6e-3;
    const Eigen::Vector3d centre = axle.At("wheel_centre");
    Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
    if (IsKnown(axle, "wheel_axis") && (axle.At("wheel_axis") - centre).norm() > kNoLength)
      axis = (axle.At("wheel_axis") - centre).normalized();
    const double beside = std::abs(axis.dot(axle.At("contact") - centre));
    if (beside > kUsual) Report(PointOf(axle, "contact"), kContactBeside, {axle.axle, Millimetres(beside)});
  }

  void CheckOrder() {
    if (!IsKnown(car_[0], "wheel_centre") || !IsKnown(car_[1], "wheel_centre")) return;
    const double front = car_[0].At("wheel_centre").x();
    const double rear = car_[1].At("wheel_centre").x();
    if (front - rear < kLeastWheelbase)
      Report(PointOf(car_[1], "wheel_centre"), kAxleOrder, {Millimetres(front), Millimetres(rear)});
  }

 private:
  void Report(const HardPoint& point, const Finding& finding, const std::vector<std::string>& words) {
    diagnostics_.Report(finding, {file_, point.line}, words);
  }

  static const HardPoint& PointOf(const AxlePoints& axle, std::string_view name) {
    return axle.points.find(name)->second;
  }

  /// Its place can be used.
  static bool IsKnown(const AxlePoints& axle, std::string_view name) {
    return axle.Has(name) && axle.At(name).allFinite();
  }

  void ReportUnknown(const HardPoint& point, const SuspensionKind& kind) {
    std::vector<std::string_view> names;
    for (const PointSpec& spec : kind.points) names.push_back(spec.name);
    Report(point, kPointUnknown,
           {std::string(kind.name), point.name, DidYouMeanOrAll(point.name, std::span<const std::string_view>(names))});
  }

  void CheckCarrier(const HardPoint& point, const PointSpec& spec, const SuspensionKind& kind) {
    if (point.on.empty()) return;
    if (std::find(spec.carriers.begin(), spec.carriers.end(), point.on) != spec.carriers.end()) return;
    Report(point, kPointCarrier,
           {point.name, point.on, std::string(kind.name),
            spec.carriers.empty() ? std::string()
                                  : DidYouMeanOrAll(point.on, std::span<const std::string_view>(spec.carriers))});
  }

  void CheckSide(const HardPoint& point, const PointSpec& spec) {
    const double y = point.xyz.y();
    if (spec.side == PointSpec::Side::kLeft && y <= 0)
      Report(point, kPointSide, {point.axle, point.name, Millimetres(y), "it belongs to the left side"});
    if (spec.side == PointSpec::Side::kMiddle && std::abs(y) > kMiddle)
      Report(point, kPointSide, {point.axle, point.name, Millimetres(y), "it belongs to the plane of symmetry, y = 0"});
  }

  void CheckThere(const AxlePoints& axle, const PointSpec& spec) {
    if (axle.Has(spec.name)) {
      const PointSpec* const partner = axle.kind->Find(spec.partner);
      if (spec.need == PointSpec::Need::kOptional && partner && !axle.Has(spec.partner))
        Report(PointOf(axle, spec.name), kPointPartnerMissing,
               {axle.axle, std::string(spec.name), std::string(spec.partner)});
    } else if (spec.need == PointSpec::Need::kNeeded) {
      Report({}, kPointMissing,
             {axle.axle, std::string(axle.kind->name), std::string(spec.name), std::string(spec.meaning), axle.axle,
              std::string(spec.name)});
    }
  }

  void CheckConvergence(const AxlePoints& axle) {
    double greatest = 0;
    for (const std::string pair : {"lower", "upper"}) {
      if (!IsKnown(axle, pair + "_body") || !IsKnown(axle, pair + "_axle")) return;
      const Eigen::Vector3d link = axle.At(pair + "_body") - axle.At(pair + "_axle");
      greatest = std::max(greatest, std::atan2(std::abs(link.y()), std::abs(link.x())));
    }
    if (greatest >= kLeastConvergence) return;
    const double degrees = std::round(greatest * 1800 / std::numbers::pi);
    Report(PointOf(axle, "upper_body"), kLinksParallel, {axle.axle, FormatNumber(degrees, -1) + " deg"});
  }

  void CheckArm(const AxlePoints& axle, const ArmSpec& arm) {
    if (!IsKnown(axle, arm.first) || !IsKnown(axle, arm.second) || !IsKnown(axle, arm.end)) return;
    const Eigen::Vector3d along = axle.At(arm.second) - axle.At(arm.first);
    if (along.norm() < kNoLength) return;
    const double length = along.normalized().cross(axle.At(arm.end) - axle.At(arm.first)).norm();
    if (length < kNoLength)
      Report(PointOf(axle, arm.end), kArmWithoutLength,
             {axle.axle, std::string(arm.end), Millimetres(length), std::string(arm.first), std::string(arm.second)});
  }

  CarPoints& car_;
  std::string file_;
  Diagnostics& diagnostics_;
};

std::string Quoted(std::string_view text) {
  return text.find(',') == std::string_view::npos ? std::string(text) : '"' + std::string(text) + '"';
}

}  // namespace

std::optional<std::array<const SuspensionKind*, 2>> ChosenSuspensions(const std::vector<std::string>& choices,
                                                                      Diagnostics& diagnostics) {
  const Place option = Place::Option("--suspension");
  std::array<const SuspensionKind*, 2> kinds = {};
  std::array<bool, 2> is_named = {};
  for (const std::string& choice : choices) {
    const std::size_t equals = choice.find('=');
    if (equals == std::string::npos) {
      diagnostics.Report(kSuspensionMalformed, option, {choice});
      continue;
    }
    const std::string axle = choice.substr(0, equals);
    const std::string kind = choice.substr(equals + 1);
    const auto found = std::find(kAxles.begin(), kAxles.end(), axle);
    if (found == kAxles.end()) {
      diagnostics.Report(kSuspensionAxle, option, {axle});
      continue;
    }
    const std::size_t i = static_cast<std::size_t>(found - kAxles.begin());
    if (is_named[i]) diagnostics.Report(kSuspensionTwice, option, {axle});
    is_named[i] = true;
    kinds[i] = FindSuspensionKind(kind);
    if (!kinds[i]) {
      const std::vector<std::string> names = KindNames();
      diagnostics.Report(kSuspensionKindUnknown, option, {kind, DidYouMeanOrAll(kind, std::span(names))});
    }
  }
  for (std::size_t i = 0; i < kAxles.size(); ++i)
    if (!is_named[i]) diagnostics.Report(kSuspensionMissing, option, {std::string(kAxles[i]), std::string(kAxles[i])});
  if (diagnostics.HasErrors()) return std::nullopt;
  return kinds;
}

std::vector<HardPoint> UsualPoints(const std::array<const SuspensionKind*, 2>& kinds) {
  std::vector<HardPoint> points;
  for (std::size_t i = 0; i < kAxles.size(); ++i)
    for (const PointSpec& spec : kinds[i]->points) {
      // As a drawing has it: no wheel_axis where wheels stand straight, one damper within the coil.
      const bool is_within_coil = spec.need == PointSpec::Need::kOptional && spec.name.starts_with("damper") &&
                                  kinds[i]->Find("damper_top")->y == kinds[i]->Find("spring_top")->y;
      if (spec.name == "wheel_axis" || is_within_coil) continue;
      points.push_back({.axle = std::string(kAxles[i]),
                        .name = std::string(spec.name),
                        .xyz = {spec.x - (i == 0 ? 0 : kWheelbase), spec.y, spec.z}});
    }
  return points;
}

CarPoints SortedPoints(const std::array<const SuspensionKind*, 2>& kinds, const std::vector<HardPoint>& points,
                       const std::string& file, Diagnostics& diagnostics) {
  CarPoints car;
  for (std::size_t i = 0; i < kAxles.size(); ++i) car[i] = {.axle = std::string(kAxles[i]), .kind = kinds[i]};
  PointCheck check(car, file, diagnostics);
  for (const HardPoint& point : points) check.Sort(point);
  for (const AxlePoints& axle : car) check.CheckAxle(axle);
  check.CheckOrder();
  return car;
}

std::string PointsText(const CarPoints& car) {
  std::string text =
      "# Hard points of the left side, car at rest; x forward, y left, z up from the drawing's origin, which may lie\n"
      "# anywhere in the plane of symmetry. For x to the rear or y to the right write -x or -y in the header; for "
      "other\n"
      "# units [m]. 'on' names the part that carries a point where that is not the usual one.\n"
      "axle,point,x [mm],y [mm],z [mm],on,note\n";
  for (const AxlePoints& axle : car) {
    text += "# " + axle.axle + ": " + std::string(axle.kind->name) + ", " + std::string(axle.kind->summary) + "\n";
    for (const PointSpec& spec : axle.kind->points) {
      std::string note(spec.meaning);
      if (spec.need == PointSpec::Need::kOptional) note = "optional: " + note;
      std::string row = axle.axle + "," + std::string(spec.name);
      const auto found = axle.points.find(spec.name);
      if (found == axle.points.end()) {
        // Shown, not used.
        row = "# " + row + ",,,,";
      } else {
        for (const double metres : found->second.xyz) row += "," + FormatNumber(std::round(metres * 1e6) + 0.0, -3);
        row += "," + found->second.on;
      }
      if (spec.carriers.size() > 1) {
        note += "; on ";
        for (std::size_t i = 0; i < spec.carriers.size(); ++i)
          note += (i == 0 ? "" : " or ") + std::string(spec.carriers[i]);
      }
      text += row + "," + Quoted(note) + "\n";
    }
  }
  return text;
}

}  // namespace fourpost
