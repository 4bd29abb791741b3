#include "vehicles/lint/static_lint.h"

#include <cmath>
#include <numeric>
#include <set>

#include "vehicles/description/element_list.h"

namespace fourpost {
namespace {

/// A load of the weight's rounding, and of preloads typed with seven digits.
double Trifle(const LintSubject& subject) { return 1e-6 * subject.Weight(); }

/// What else than tyres stands on the ground: elements, and if there is none joints.
std::vector<std::string> Props(const Vehicle& vehicle) {
  std::vector<std::string> props;
  const auto add = [&](const std::string& name) {
    if (props.empty() || props.back() != name) props.push_back(name);
  };
  for (const ElementPoint& item : PointsOf(vehicle))
    if (item.point.link == 0) add(item.element);
  if (!props.empty()) return props;
  for (const Joint& joint : vehicle.joints)
    if (joint.parent == 0 && joint.type != Joint::Type::kFloating) add(Called("joint", joint.name));
  return props;
}

std::string Listed(const std::vector<std::string>& names) {
  return std::accumulate(names.begin(), names.end(), std::string(), [](const std::string& list, const auto& name) {
    return list.empty() ? name : list + ", " + name;
  });
}

}  // namespace

void LintTyreLoads(const LintSubject& subject, FileFaults& findings) {
  for (std::size_t i = 0; i < subject.vehicle.tyres.size(); ++i) {
    const Tyre& tyre = subject.vehicle.tyres[i];
    const double load = subject.model.preloads.tyre[i];
    if (load < -Trifle(subject))
      findings.Warning(tyre.source_line, Called("fp:tyre", tyre.name) + " pulls on its platform with " +
                                             Readable(-load, "N") +
                                             " at rest: check where the masses are and what preloads are given");
  }
}

void LintSpringLoads(const LintSubject& subject, FileFaults& findings) {
  for (std::size_t i = 0; i < subject.vehicle.springs.size(); ++i) {
    const Spring& spring = subject.vehicle.springs[i];
    const double tension = subject.model.preloads.spring[i];
    if (!spring.preload && !spring.free_length && tension > Trifle(subject))
      findings.Warning(spring.source_line,
                       spring.Element() + " is pulled with " + Readable(tension, "N") +
                           " at rest, which a coil does not bear: check its ends" +
                           (spring.line.axis ? ", and its axis, which points from child to parent" : ""));
  }
}

void LintWeightOnTyres(const LintSubject& subject, FileFaults& findings) {
  constexpr double kShare = 0.01;
  const std::vector<double>& loads = subject.model.preloads.tyre;
  if (loads.empty()) return;
  const double sum = std::accumulate(loads.begin(), loads.end(), 0.0);
  const double weight = subject.Weight();
  if (std::abs(sum - weight) <= kShare * weight) return;
  const std::vector<std::string> props = Props(subject.vehicle);
  findings.Warning(0, "the tyres carry " + Readable(sum, "N") + " at rest, but the vehicle weighs " +
                          Readable(weight, "N") + ": the rest is on " +
                          (props.empty() ? "nothing that is known" : Listed(props)) +
                          "; free that, or take the loads for those of a guided vehicle");
}

}  // namespace fourpost
