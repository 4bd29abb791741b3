#include "vehicles/symmetry_lint.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "vehicles/element_list.h"
#include "vehicles/mirror_partner.h"

namespace fourpost {
namespace {

/// Calls `compare` with each left item and its right partner; the two are of one part.
template <typename Item, typename Part, typename Compare>
void ForEachPair(const std::vector<Item>& items, const Part& part, const Compare& compare) {
  for (const Item& left : items)
    for (const std::string& name : MirrorPartners(left.element))
      for (const Item& right : items)
        if (right.element == name && std::string_view(part(right)) == part(left)) compare(left, right);
}

}  // namespace

void LintMirroredPoints(const LintSubject& subject, FileFaults& findings) {
  constexpr double kExact_m = 1e-4;
  constexpr double kNear_m = 0.05;
  constexpr double kNearShare = 0.2;
  const auto compare = [&](const ElementPoint& left, const ElementPoint& right) {
    const Eigen::Vector3d image = subject.Place(left.point).cwiseProduct(Eigen::Vector3d(1, -1, 1));
    const double gap = (subject.Place(right.point) - image).norm();
    if (gap <= kExact_m || gap >= std::max(kNear_m, kNearShare * std::abs(image.y()))) return;
    findings.Warning(right.line, std::string(right.part) + " of " + right.element + " is " + Readable(gap, "m") +
                                     " off the mirror image of that of " + left.element + " (line " +
                                     std::to_string(left.line) + ") in the design pose: correct one, or use fp:mirror");
  };
  ForEachPair(
      PointsOf(subject.vehicle), [](const ElementPoint& point) { return point.part; }, compare);
}

void LintMirroredNumbers(const LintSubject& subject, FileFaults& findings) {
  constexpr double kRatio = 10;
  const auto compare = [&](const ElementNumber& left, const ElementNumber& right) {
    const double a = std::abs(subject.At(left.number));
    const double b = std::abs(subject.At(right.number));
    if (std::max(a, b) < kRatio * std::min(a, b) || std::max(a, b) == 0) return;
    findings.Warning(right.line, std::string(right.kind.noun) + " of " + right.element + " is " +
                                     Readable(b, right.kind.si_unit) + ", that of " + left.element + " (line " +
                                     std::to_string(left.line) + ") " + Readable(a, left.kind.si_unit) +
                                     ": correct one of them");
  };
  ForEachPair(
      NumbersOf(subject.vehicle), [](const ElementNumber& number) { return number.kind.noun; }, compare);
}

void LintBarSides(const LintSubject& subject, FileFaults& findings) {
  constexpr double kAside_m = 0.01;
  const auto side = [&](const ForceLine& line) {
    return 0.5 * (subject.Place(line.parent).y() + subject.Place(line.child).y());
  };
  for (const AntiRollBar& bar : subject.vehicle.antiroll_bars) {
    const double left = side(bar.left);
    const double right = side(bar.right);
    if (left * right <= 0 || std::min(std::abs(left), std::abs(right)) < kAside_m) continue;
    findings.Warning(bar.source_line, "both lines of " + Called("fp:antiroll", bar.name) + " are on the " +
                                          (left > 0 ? "left" : "right") +
                                          " of the car: give one the points of the other side");
  }
}

}  // namespace fourpost
