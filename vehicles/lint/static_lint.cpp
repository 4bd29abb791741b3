#include "vehicles/lint/static_lint.h"

#include <cmath>
#include <numeric>
#include <set>

#include "vehicles/description/element_list.h"
#include "vehicles/lint/findings.h"

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
      findings.Report(kTyrePullsAtRest, tyre.source_line, {Called("fp:tyre", tyre.name), Readable(-load, "N")});
  }
}

void LintSpringLoads(const LintSubject& subject, FileFaults& findings) {
  for (std::size_t i = 0; i < subject.vehicle.springs.size(); ++i) {
    const Spring& spring = subject.vehicle.springs[i];
    const double tension = subject.model.preloads.spring[i];
    if (!spring.preload && !spring.free_length && tension > Trifle(subject))
      findings.Report(kSpringPulled, spring.source_line,
                      {spring.Element(), Readable(tension, "N"),
                       spring.line.axis ? ", and its axis, which points from child to parent" : ""});
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
  findings.Report(kWeightElsewhere, 0,
                  {Readable(sum, "N"), Readable(weight, "N"), props.empty() ? "unknown supports" : Listed(props)});
}

}  // namespace fourpost
