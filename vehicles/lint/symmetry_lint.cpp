#include "vehicles/lint/symmetry_lint.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "analysis/units.h"
#include "vehicles/description/element_list.h"
#include "vehicles/description/mirror_partner.h"

namespace fourpost {
namespace {

/// Calls `compare` with each left item and its right partner; the two are of one part.
template <typename Item, typename Part, typename Compare>
void ForEachPair(const std::vector<Item>& items, const Part& part, const Compare& compare) {
  std::multimap<std::string_view, const Item*> by_element;
  for (const Item& item : items) by_element.emplace(item.element, &item);
  for (const Item& left : items)
    for (const std::string& name : MirrorPartners(left.element)) {
      const auto [begin, end] = by_element.equal_range(name);
      for (auto right = begin; right != end; ++right)
        if (part(*right->second) == part(left)) compare(left, *right->second);
    }
}

}  // namespace

void LintMirroredPoints(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kExact_m = 1e-4;
  constexpr double kNear_m = 0.05;
  constexpr double kNearShare = 0.2;
  const auto compare = [&](const ElementPoint& left, const ElementPoint& right) {
    const Eigen::Vector3d image = drawn.Place(left.point).cwiseProduct(Eigen::Vector3d(1, -1, 1));
    const double gap = (drawn.Place(right.point) - image).norm();
    if (gap <= kExact_m || gap >= std::max(kNear_m, kNearShare * std::abs(image.y()))) return;
    findings.Warning(right.line, std::string(right.part) + " of " + right.element + " is " + Readable(gap, "m") +
                                     " off the mirror image of that of " + left.element + " (line " +
                                     std::to_string(left.line) + ") in the design pose: correct one, or use fp:mirror");
  };
  ForEachPair(
      PointsOf(drawn.vehicle), [](const ElementPoint& point) { return std::string_view(point.part); }, compare);
}

void LintMirroredNumbers(const DrawnVehicle& drawn, FileFaults& findings) {
  // Nobody types a number twice with other digits; what was identified for each side may well differ.
  constexpr double kTyped = 1.01;
  constexpr double kOfParameters = 1.5;
  const auto compare = [&](const ElementNumber& left, const ElementNumber& right) {
    const double a = drawn.At(left.number);
    const double b = drawn.At(right.number);
    const bool is_typed = left.number.parameter < 0 && right.number.parameter < 0;
    const double most = std::max(std::abs(a), std::abs(b));
    const double ratio = is_typed ? kTyped : kOfParameters;
    if (a * b >= 0 && most <= ratio * std::min(std::abs(a), std::abs(b))) return;
    const std::string si_unit = SiUnit(right.rule->dimension);
    findings.Warning(right.line, right.noun + " of " + right.element + " is " + Readable(b, si_unit) + ", that of " +
                                     left.element + " (line " + std::to_string(left.line) + ") " +
                                     Readable(a, si_unit) + ": correct one of them" +
                                     (is_typed ? ", or make them parameters if they were measured so" : ""));
  };
  ForEachPair(
      NumbersOf(drawn.vehicle), [](const ElementNumber& number) { return std::string_view(number.noun); }, compare);
}

void LintBarSides(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kAside_m = 0.01;
  const auto side = [&](const ForceLine& line) {
    return 0.5 * (drawn.Place(line.parent).y() + drawn.Place(line.child).y());
  };
  for (const AntiRollBar& bar : drawn.vehicle.antiroll_bars) {
    const double left = side(bar.left);
    const double right = side(bar.right);
    if (left * right <= 0 || std::min(std::abs(left), std::abs(right)) < kAside_m) continue;
    findings.Warning(bar.source_line, "both lines of " + Called("fp:antiroll", bar.name) + " are on the " +
                                          (left > 0 ? "left" : "right") +
                                          " of the car: give one the points of the other side");
  }
}

}  // namespace fourpost
