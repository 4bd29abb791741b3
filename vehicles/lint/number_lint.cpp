#include "vehicles/lint/number_lint.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include "analysis/text/units.h"
#include "vehicles/description/element_list.h"

namespace fourpost {
namespace {

/// At which dampers are judged, as DashpotLaw::MeanRate does.
constexpr double kUsualSpeed_mps = 0.1;

/// Of an attribute [SI].
struct Range {
  double least = 0;
  double greatest = std::numeric_limits<double>::infinity();

  explicit Range(const AttributeRule& rule) {
    if (!rule.usual_least.empty()) least = ParseQuantity(rule.usual_least)->si;
    if (!rule.usual_greatest.empty()) greatest = ParseQuantity(rule.usual_greatest)->si;
  }

  bool Holds(double number) const { return number >= least && number <= greatest; }
};

/// The unit in which the user sees the number; empty for one that follows no parameter.
std::string UnitOf(const DrawnVehicle& drawn, const Scalar& number) {
  if (number.parameter < 0) return "";
  return drawn.vehicle.parameters[static_cast<std::size_t>(number.parameter)].unit;
}

/// "; was 280 kN/m meant?"
std::string Guess(double number, const Range& range, const std::string& si_unit) {
  for (const double factor : {1e3, 1e-3, 1e6, 1e-6})
    if (range.Holds(factor * std::abs(number))) return "; was " + Readable(factor * number, si_unit) + " meant?";
  return "; check its digits and its unit";
}

std::string Bounds(const Range& range, const std::string& si_unit) {
  if (range.least == 0) return "above " + Readable(range.greatest, si_unit);
  return "not within " + Readable(range.least, si_unit) + " to " + Readable(range.greatest, si_unit);
}

/// What is odd about a number; `unit`: that in which the user sees it.
std::string Oddity(double number, const AttributeRule& rule, const std::string& unit) {
  const Range range(rule);
  if (number == 0 || range.Holds(std::abs(number))) return "";
  const std::string si_unit = SiUnit(rule.dimension);
  return " is " + Readable(number, si_unit, unit) + ", " + Bounds(range, si_unit) + Guess(number, range, si_unit);
}

/// The damper's law without what friction adds, at its file's values [N].
std::function<double(double)> OilForce(const DrawnVehicle& drawn, const Damper& damper) {
  if (damper.hydraulic)
    return [law = damper.hydraulic->At(drawn.values)](double speed) mutable {
      law.friction = 0;
      return law.SteadyForce(speed);
    };
  DashpotDescription law = damper.law;
  law.friction.reset();
  return [law = law.At(drawn.values)](double speed) { return law.Force(speed); };
}

/// Whether the file gives a damper's rates themselves.
bool StatesRates(const Damper& damper) {
  return !damper.hydraulic && damper.law.kind == DashpotDescription::Kind::kBilinear;
}

}  // namespace

void LintNumbers(const DrawnVehicle& drawn, FileFaults& findings) {
  std::set<std::pair<std::string, std::string>> told;
  for (const ElementNumber& item : NumbersOf(drawn.vehicle)) {
    const std::string oddity = Oddity(drawn.At(item.number), *item.rule, UnitOf(drawn, item.number));
    // Of a table's points the first is enough.
    if (!oddity.empty() && told.emplace(item.element, item.noun).second)
      findings.Warning(item.line, item.noun + " of " + item.element + oddity);
  }
}

void LintMeanRates(const DrawnVehicle& drawn, FileFaults& findings) {
  const AttributeRule& rule = *FindAttribute(*FindTags("fp:damper/linear").front(), "rate");
  for (const Damper& damper : drawn.vehicle.dampers) {
    if (StatesRates(damper)) continue;
    const auto force = OilForce(drawn, damper);
    const double rate = (force(kUsualSpeed_mps) - force(-kUsualSpeed_mps)) / (2 * kUsualSpeed_mps);
    const std::string oddity = Oddity(rate, rule, "");
    if (!oddity.empty())
      findings.Warning(damper.source_line, "mean rate of " + Called("fp:damper", damper.name) + " up to " +
                                               Readable(kUsualSpeed_mps, "m/s") + oddity);
  }
}

void LintHardening(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kTravel_m = 0.01;
  // Rubber in line with a damper gives way by tenths of that.
  constexpr double kSeriesTravel_m = 0.001;
  constexpr double kMost = 100;
  const auto check = [&](const std::string& element, int line, const Scalar& stiffness, const Scalar& cubic,
                         double travel_m) {
    const double linear = drawn.At(stiffness) * travel_m;
    const double hardening = drawn.At(cubic) * travel_m * travel_m * travel_m;
    if (linear == 0 || hardening <= kMost * linear) return;
    findings.Warning(line, "cubic of " + element + " makes " + Readable(hardening, "N") + " at " +
                               Readable(travel_m, "m") + ", its stiffness " + Readable(linear, "N") +
                               ": check its digits and its unit");
  };
  for (const Spring& spring : drawn.vehicle.springs) {
    check(spring.Element(), spring.source_line, spring.law.stiffness, spring.law.cubic, kTravel_m);
    for (const SpringDescription::Knee& knee : spring.law.knees)
      check(spring.Element(), spring.source_line, knee.rate, knee.cubic, kTravel_m);
  }
  for (const Damper& damper : drawn.vehicle.dampers)
    if (damper.series)
      check("the series spring of " + Called("fp:damper", damper.name), damper.source_line, damper.series->stiffness,
            damper.series->cubic, kSeriesTravel_m);
}

void LintPlacesInMillimetres(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kFar_m = 50;
  const auto check = [&](const std::string& what, int line, const Eigen::Vector3d& xyz) {
    if (xyz.norm() <= kFar_m) return;
    findings.Warning(line, what + " is " + Readable(xyz.norm(), "m") + " from the origin of its axes; was " +
                               Readable(1e-3 * xyz.norm(), "m") + " meant? xyz is in metres");
  };
  for (const ElementPoint& item : PointsOf(drawn.vehicle))
    check(std::string(item.part) + " of " + item.element, item.line, item.point.xyz);
  for (const Joint& joint : drawn.vehicle.joints)
    check("the origin of " + Called("joint", joint.name), joint.line, joint.pose.translation());
}

void LintStopGaps(const DrawnVehicle& drawn, FileFaults& findings) {
  for (const Spring& spring : drawn.vehicle.springs) {
    std::set<int> closed;
    for (const SpringDescription::Knee& knee : spring.law.knees)
      if (knee.adds && drawn.At(knee.at) == 0) closed.insert(knee.side);
    if (closed.size() == 2)
      findings.Warning(
          spring.source_line,
          spring.Element() + " has no gap on either side, so that it acts as a spring: give its gaps, or make it one");
  }
}

void LintGaps(const DrawnVehicle& drawn, FileFaults& findings) {
  for (const Spring& spring : drawn.vehicle.springs) {
    if (spring.line.axis) continue;
    const double length = drawn.Length(spring.line);
    for (const SpringDescription::Knee& knee : spring.law.knees)
      if (knee.side < 0 && drawn.At(knee.at) >= length)
        findings.Warning(spring.source_line, spring.Element() + " is " + Readable(length, "m") +
                                                 " long in the design pose, so it is never compressed by " +
                                                 Readable(drawn.At(knee.at), "m") +
                                                 ": correct its ends, its gap or its knee");
  }
}

void LintOilColumns(const DrawnVehicle& drawn, FileFaults& findings) {
  const auto joins_same = [](const ForceLine& a, const ForceLine& b) {
    return std::minmax(a.parent.link, a.child.link) == std::minmax(b.parent.link, b.child.link);
  };
  for (const Damper& damper : drawn.vehicle.dampers)
    for (const Spring& stop : drawn.vehicle.springs) {
      if (!damper.hydraulic || stop.kind != Spring::Kind::kStop || !joins_same(damper.line, stop.line)) continue;
      for (const SpringDescription::Knee& knee : stop.law.knees) {
        const HydraulicDescription& oil = *damper.hydraulic;
        const double column = drawn.At(knee.side < 0 ? oil.compression_column : oil.rebound_column);
        if (drawn.At(knee.at) >= column)
          findings.Warning(damper.source_line,
                           (knee.side < 0 ? "the compression column of " : "the rebound column of ") +
                               Called("fp:damper", damper.name) + " is " + Readable(column, "m") + " long, but " +
                               stop.Element() + " begins after " + Readable(drawn.At(knee.at), "m") +
                               ": the piston meets the end before the stop; correct one of them");
      }
    }
}

void LintSwappedDamping(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kLeastRatio = 0.2;
  for (const Damper& damper : drawn.vehicle.dampers) {
    const auto force = OilForce(drawn, damper);
    const double bump = -force(-kUsualSpeed_mps) / kUsualSpeed_mps;
    const double rebound = force(kUsualSpeed_mps) / kUsualSpeed_mps;
    if (rebound >= kLeastRatio * bump) continue;
    findings.Warning(damper.source_line, Called("fp:damper", damper.name) + " resists compression with " +
                                             Readable(bump, "N*s/m") + " and rebound with " +
                                             Readable(rebound, "N*s/m") +
                                             (StatesRates(damper) ? "" : " at " + Readable(kUsualSpeed_mps, "m/s")) +
                                             ": are the two swapped?");
  }
}

}  // namespace fourpost
