#include "vehicles/lint/symmetry_lint.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/text/units.h"
#include "vehicles/description/element_list.h"
#include "vehicles/description/mirror_partner.h"
#include "vehicles/lint/findings.h"
#include "vehicles/lint/number_rule.h"

namespace fourpost {
namespace {

/// Calls `compare` with each left point and its right partner; the two are of one part.
template <typename Compare>
void ForEachPair(const std::vector<ElementPoint>& points, const Compare& compare) {
  std::multimap<std::string_view, const ElementPoint*> by_element;
  for (const ElementPoint& point : points) by_element.emplace(point.element, &point);
  for (const ElementPoint& left : points)
    for (const std::string& name : MirrorPartners(left.element)) {
      const auto [begin, end] = by_element.equal_range(name);
      for (auto right = begin; right != end; ++right)
        if (std::string_view(right->second->part) == left.part) compare(left, *right->second);
    }
}

/// Of one element, in the order of its file.
using NumbersOfOne = std::vector<const ElementNumber*>;

/// Numbers of one kind, such as the forces of a table.
NumbersOfOne Alike(const NumbersOfOne& numbers, const std::string& noun) {
  NumbersOfOne alike;
  for (const ElementNumber* number : numbers)
    if (number->noun == noun) alike.push_back(number);
  return alike;
}

/// The words of kMirrorNumber; empty where the two agree.
std::vector<std::string> Difference(const DrawnVehicle& drawn, const ElementNumber& left, const ElementNumber& right) {
  // Nobody types a number twice with other digits; what was identified for each side may well differ.
  constexpr double kTyped = 1.01;
  constexpr double kOfParameters = 1.5;
  const double a = drawn.At(left.number);
  const double b = drawn.At(right.number);
  const bool is_typed = left.number.parameter < 0 && right.number.parameter < 0;
  const double most = std::max(std::abs(a), std::abs(b));
  const double ratio = is_typed ? kTyped : kOfParameters;
  if (a * b >= 0 && most <= ratio * std::min(std::abs(a), std::abs(b))) return {};
  const std::string si_unit = SiUnit(RuleOf(right).dimension);
  return {right.noun,
          right.element,
          Readable(b, si_unit),
          left.element,
          std::to_string(left.line),
          Readable(a, si_unit),
          is_typed ? ", or make them parameters if they were measured so" : ""};
}

/// Where the numbers of two elements that mirror each other differ, if they do: those of a kind one by one. Laws of
/// other kinds, or tables of other lengths, are not compared number by number.
std::vector<std::string> FirstDifference(const DrawnVehicle& drawn, const NumbersOfOne& left,
                                         const NumbersOfOne& right) {
  for (std::size_t i = 0; i < right.size(); ++i) {
    const std::string& noun = right[i]->noun;
    const NumbersOfOne on_left = Alike(left, noun);
    const NumbersOfOne on_right = Alike(right, noun);
    if (on_left.size() != on_right.size()) continue;
    const auto place =
        static_cast<std::size_t>(std::find(on_right.begin(), on_right.end(), right[i]) - on_right.begin());
    std::vector<std::string> difference = Difference(drawn, *on_left[place], *right[i]);
    if (!difference.empty()) return difference;
  }
  return {};
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
    findings.Report(
        kMirrorPoint, right.line,
        {std::string(right.part), right.element, Readable(gap, "m"), left.element, std::to_string(left.line)});
  };
  ForEachPair(PointsOf(drawn.vehicle), compare);
}

void LintMirroredNumbers(const DrawnVehicle& drawn, FileFaults& findings) {
  const std::vector<ElementNumber> numbers = NumbersOf(drawn.vehicle);
  std::map<std::string_view, NumbersOfOne> by_element;
  for (const ElementNumber& number : numbers) by_element[number.element].push_back(&number);
  for (const auto& [element, left] : by_element)
    for (const std::string& name : MirrorPartners(std::string(element))) {
      const auto right = by_element.find(name);
      if (right == by_element.end()) continue;
      const std::vector<std::string> difference = FirstDifference(drawn, left, right->second);
      if (!difference.empty()) findings.Report(kMirrorNumber, right->second.front()->line, difference);
    }
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
    findings.Report(kBarSide, bar.source_line, {Called("fp:antiroll", bar.name), left > 0 ? "left" : "right"});
  }
}

}  // namespace fourpost
