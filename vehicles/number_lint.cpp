#include "vehicles/number_lint.h"

#include <algorithm>
#include <set>

#include "vehicles/element_list.h"

namespace fourpost {
namespace {

bool IsUsual(double number, const NumberKind& kind) { return number >= kind.least && number <= kind.greatest; }

/// The unit in which the user sees the number; empty for one that follows no parameter.
std::string UnitOf(const LintSubject& subject, const Scalar& number) {
  if (number.parameter < 0) return "";
  return subject.vehicle.parameters[static_cast<std::size_t>(number.parameter)].unit;
}

/// "; was 280 kN/m meant?"
std::string Guess(double number, const NumberKind& kind) {
  for (const double factor : {1e3, 1e-3, 1e6, 1e-6})
    if (IsUsual(factor * number, kind)) return "; was " + Readable(factor * number, kind.si_unit) + " meant?";
  return "; check its digits and its unit";
}

std::string Range(const NumberKind& kind) {
  if (kind.least == 0) return "above " + Readable(kind.greatest, kind.si_unit);
  return "not within " + Readable(kind.least, kind.si_unit) + " to " + Readable(kind.greatest, kind.si_unit);
}

}  // namespace

void LintNumbers(const LintSubject& subject, FileFaults& findings) {
  for (const ElementNumber& item : NumbersOf(subject.vehicle)) {
    const double number = subject.At(item.number);
    if (number == 0 || IsUsual(number, item.kind)) continue;
    findings.Warning(item.line, std::string(item.kind.noun) + " of " + item.element + " is " +
                                    Readable(number, item.kind.si_unit, UnitOf(subject, item.number)) + ", " +
                                    Range(item.kind) + Guess(number, item.kind));
  }
}

void LintHardening(const LintSubject& subject, FileFaults& findings) {
  constexpr double kTravel_m = 0.01;
  constexpr double kMost = 100;
  const auto check = [&](const std::string& element, int line, const Scalar& stiffness, const Scalar& cubic) {
    const double linear = subject.At(stiffness) * kTravel_m;
    const double hardening = subject.At(cubic) * kTravel_m * kTravel_m * kTravel_m;
    if (linear == 0 || hardening <= kMost * linear) return;
    findings.Warning(line, "cubic of " + element + " makes " + Readable(hardening, "N") + " at " +
                               Readable(kTravel_m, "m") + ", its stiffness " + Readable(linear, "N") +
                               ": check its digits and its unit");
  };
  for (const Spring& spring : subject.vehicle.springs) {
    check(spring.element, spring.source_line, spring.law.stiffness, spring.law.cubic);
    for (const SpringDescription::Knee& knee : spring.law.knees)
      check(spring.element, spring.source_line, knee.rate, knee.cubic);
  }
  for (const Damper& damper : subject.vehicle.dampers)
    if (damper.series)
      check("the series spring of " + Called("fp:damper", damper.name), damper.source_line, damper.series->stiffness,
            damper.series->cubic);
}

void LintPlacesInMillimetres(const LintSubject& subject, FileFaults& findings) {
  constexpr double kFar_m = 50;
  const auto check = [&](const std::string& what, int line, const Eigen::Vector3d& xyz) {
    if (xyz.norm() <= kFar_m) return;
    findings.Warning(line, what + " is " + Readable(xyz.norm(), "m") + " from the origin of its axes; was " +
                               Readable(1e-3 * xyz.norm(), "m") + " meant? xyz is in metres");
  };
  for (const ElementPoint& item : PointsOf(subject.vehicle))
    check(std::string(item.part) + " of " + item.element, item.line, item.point.xyz);
  for (const Joint& joint : subject.vehicle.joints)
    check("the origin of " + Called("joint", joint.name), joint.line, joint.pose.translation());
}

void LintStopGaps(const LintSubject& subject, FileFaults& findings) {
  for (const Spring& spring : subject.vehicle.springs) {
    std::set<int> closed;
    for (const SpringDescription::Knee& knee : spring.law.knees)
      if (knee.adds && subject.At(knee.at) == 0) closed.insert(knee.side);
    if (closed.size() == 2)
      findings.Warning(
          spring.source_line,
          spring.element + " has no gap on either side, so that it acts as a spring: give its gaps, or make it one");
  }
}

void LintSwappedDamping(const LintSubject& subject, FileFaults& findings) {
  constexpr double kLeastRatio = 0.2;
  for (const Damper& damper : subject.vehicle.dampers) {
    const double bump = subject.At(damper.law.compression);
    const double rebound = subject.At(damper.law.rebound);
    if (rebound >= kLeastRatio * bump) continue;
    findings.Warning(damper.source_line, Called("fp:damper", damper.name) + " resists compression with " +
                                             Readable(bump, "N*s/m") + " and rebound with " +
                                             Readable(rebound, "N*s/m") + ": are the two swapped?");
  }
}

}  // namespace fourpost
