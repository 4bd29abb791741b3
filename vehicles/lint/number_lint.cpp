#include "vehicles/lint/number_lint.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include "analysis/text/units.h"
#include "vehicles/description/element_list.h"
#include "vehicles/lint/findings.h"
#include "vehicles/lint/number_rule.h"

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

/// What was likely meant: "280 kN/m"; empty where no unit explains it.
std::string Guess(double number, const Range& range, const std::string& si_unit) {
  for (const double factor : {1e3, 1e-3, 1e6, 1e-6})
    if (range.Holds(factor * std::abs(number))) return Readable(factor * number, si_unit);
  return "";
}

std::string Bounds(const Range& range, const std::string& si_unit) {
  if (range.least == 0) return "above " + Readable(range.greatest, si_unit);
  return "not within " + Readable(range.least, si_unit) + " to " + Readable(range.greatest, si_unit);
}

/// The words for what is odd about a number: the number, the bounds and, if there is one, the guess; `unit`: that in
/// which the user sees it. Empty where nothing is odd.
std::vector<std::string> Oddity(double number, const AttributeRule& rule, const std::string& unit) {
  const Range range(rule);
  if (number == 0 || range.Holds(std::abs(number))) return {};
  const std::string si_unit = SiUnit(rule.dimension);
  std::vector<std::string> words = {Readable(number, si_unit, unit), Bounds(range, si_unit)};
  if (std::string guess = Guess(number, range, si_unit); !guess.empty()) words.push_back(std::move(guess));
  return words;
}

/// `guessed` where the oddity has a guess, else `far_off`; `subject` stands before its words.
void ReportOddity(const Finding& guessed, const Finding& far_off, int line, std::vector<std::string> subject,
                  const std::vector<std::string>& oddity, FileFaults& findings) {
  subject.insert(subject.end(), oddity.begin(), oddity.end());
  findings.Report(oddity.size() == 3 ? guessed : far_off, line, subject);
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
  std::set<std::pair<std::string, std::string>> reported;
  for (const ElementNumber& item : NumbersOf(drawn.vehicle)) {
    const auto oddity = Oddity(drawn.At(item.number), RuleOf(item), UnitOf(drawn, item.number));
    // Of a table's points the first is enough.
    if (!oddity.empty() && reported.emplace(item.element, item.noun).second)
      ReportOddity(kNumberUnusual, kNumberFarOff, item.line, {item.noun, item.element}, oddity, findings);
  }
}

void LintMeanRates(const DrawnVehicle& drawn, FileFaults& findings) {
  const AttributeRule& rule = *FindAttribute(*FindTags("fp:damper/linear").front(), "rate");
  for (const Damper& damper : drawn.vehicle.dampers) {
    if (StatesRates(damper)) continue;
    const auto force = OilForce(drawn, damper);
    const double rate = (force(kUsualSpeed_mps) - force(-kUsualSpeed_mps)) / (2 * kUsualSpeed_mps);
    const auto oddity = Oddity(rate, rule, "");
    if (!oddity.empty())
      ReportOddity(kMeanRateUnusual, kMeanRateFarOff, damper.source_line,
                   {Called("fp:damper", damper.name), Readable(kUsualSpeed_mps, "m/s")}, oddity, findings);
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
    findings.Report(kCubicDominates, line,
                    {element, Readable(hardening, "N"), Readable(travel_m, "m"), Readable(linear, "N")});
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
    findings.Report(kPlaceInMillimetres, line, {what, Readable(xyz.norm(), "m"), Readable(1e-3 * xyz.norm(), "m")});
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
    if (closed.size() == 2) findings.Report(kStopWithoutGap, spring.source_line, {spring.Element()});
  }
}

void LintGaps(const DrawnVehicle& drawn, FileFaults& findings) {
  for (const Spring& spring : drawn.vehicle.springs) {
    if (spring.line.axis) continue;
    const double length = drawn.Length(spring.line);
    for (const SpringDescription::Knee& knee : spring.law.knees)
      if (knee.side < 0 && drawn.At(knee.at) >= length)
        findings.Report(kGapBeyondLength, spring.source_line,
                        {spring.Element(), Readable(length, "m"), Readable(drawn.At(knee.at), "m")});
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
          findings.Report(kOilColumnShort, damper.source_line,
                          {knee.side < 0 ? "bump" : "rebound", Called("fp:damper", damper.name), Readable(column, "m"),
                           stop.Element(), Readable(drawn.At(knee.at), "m")});
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
    findings.Report(kDampingSwapped, damper.source_line,
                    {Called("fp:damper", damper.name), Readable(bump, "N*s/m"), Readable(rebound, "N*s/m"),
                     StatesRates(damper) ? "" : " at " + Readable(kUsualSpeed_mps, "m/s")});
  }
}

}  // namespace fourpost
