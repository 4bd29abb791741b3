#include "vehicles/place_lint.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "vehicles/element_list.h"

namespace fourpost {

void LintSensorPlaces(const LintSubject& subject, FileFaults& findings) {
  // A transducer at the end of a long bracket is within this, or within the vehicle's own size.
  constexpr double kBracket_m = 3;
  std::vector<Eigen::Vector3d> places;
  Eigen::AlignedBox3d vehicle;
  for (const ElementPoint& item : PointsOf(subject.vehicle)) {
    places.push_back(subject.Place(item.point));
    vehicle.extend(places.back());
  }
  if (places.empty()) return;
  const double reach = std::max(kBracket_m, vehicle.diagonal().norm());
  for (const ElementPoint& sensor : SensorPointsOf(subject.vehicle)) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& place : places)
      nearest = std::min(nearest, (place - subject.Place(sensor.point)).norm());
    if (nearest > reach)
      findings.Warning(sensor.line, sensor.element + " is " + Readable(nearest, "m") +
                                        " from the nearest mass, tyre and element of the vehicle: correct its xyz, "
                                        "which is in metres and in the axes of its link");
  }
}

void LintTyreHeights(const LintSubject& subject, FileFaults& findings) {
  constexpr double kLevel_m = 0.02;
  // Of a point that stands for the foot or, in models without roll, for the centre.
  constexpr double kLowest_m = -0.1;
  constexpr double kHighest_m = 1.5;
  for (const Tyre& tyre : subject.vehicle.tyres) {
    const double height = subject.Place(tyre.point).z();
    const std::string what = "the point of " + Called("fp:tyre", tyre.name) + " is " + Readable(height, "m") +
                             " above the platform, z = 0, in the design pose";
    if (tyre.radius > 0 && std::abs(height - tyre.radius) > kLevel_m)
      findings.Warning(tyre.source_line, what + ", but its radius is " + Readable(tyre.radius, "m") +
                                             ": correct the joint's origin, the point or the radius");
    if (tyre.radius == 0 && (height < kLowest_m || height > kHighest_m))
      findings.Warning(tyre.source_line, what + ": correct the joint's origin or the point");
  }
}

void LintLengths(const LintSubject& subject, FileFaults& findings) {
  constexpr double kShort_m = 0.02;
  constexpr double kLong_m = 3;
  const auto check = [&](const std::string& element, int line, const ForceLine& ends) {
    if (ends.axis) return;
    const double length = subject.pose.LineLength(ends).value;
    if (length >= kShort_m && length <= kLong_m) return;
    findings.Warning(line, element + " is " + Readable(length, "m") + " long in the design pose: " +
                               (length > kLong_m ? "correct its ends"
                                                 : "its direction turns with the least motion; correct its ends, or "
                                                   "give it an axis"));
  };
  for (const Spring& spring : subject.vehicle.springs) check(spring.element, spring.source_line, spring.line);
  for (const Damper& damper : subject.vehicle.dampers)
    check(Called("fp:damper", damper.name), damper.source_line, damper.line);
}

void LintPosts(const LintSubject& subject, FileFaults& findings) {
  const Vehicle& vehicle = subject.vehicle;
  if (vehicle.posts.empty() && !vehicle.tyres.empty())
    findings.Warning(0, "the vehicle has tyres but no post, so nothing can move it: add an fp:post under each tyre");
  for (std::size_t i = 0; i < vehicle.tyres.size() && !vehicle.posts.empty(); ++i) {
    const bool has_post = std::any_of(vehicle.posts.begin(), vehicle.posts.end(),
                                      [&](const Post& post) { return post.tyre == static_cast<int>(i); });
    if (!has_post)
      findings.Warning(vehicle.tyres[i].source_line, Called("fp:tyre", vehicle.tyres[i].name) +
                                                         " has no post while others have one: add an fp:post under it");
  }
}

void LintSensors(const LintSubject& subject, FileFaults& findings) {
  if (subject.vehicle.sensors.empty())
    findings.Warning(0, "the vehicle has no sensor, so nothing of its response is seen: add fp:sensor tags");
}

}  // namespace fourpost
