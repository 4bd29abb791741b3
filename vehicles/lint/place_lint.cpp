#include "vehicles/lint/place_lint.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "vehicles/description/body_box.h"
#include "vehicles/description/element_list.h"

namespace fourpost {

void LintSensorPlaces(const DrawnVehicle& drawn, FileFaults& findings) {
  // A transducer stands on a bracket, or on a part of the body that holds no element, as a bumper.
  constexpr double kBracket_m = 0.5;
  constexpr double kShare = 0.3;
  const BodyBoxes boxes(drawn);
  const auto off = [&](const Eigen::AlignedBox3d& box, const Eigen::Vector3d& place) {
    const double distance = box.exteriorDistance(place);
    return distance > std::max(kBracket_m, kShare * box.diagonal().norm()) ? distance : 0;
  };
  for (const ElementPoint& sensor : SensorPointsOf(drawn.vehicle)) {
    const int link = sensor.point.link;
    if (link == 0 || boxes.Of(link).isEmpty() || off(boxes.Of(link), drawn.Place(sensor.point)) == 0) continue;
    const double distance = off(boxes.WithMeshes(link), drawn.Place(sensor.point));
    if (distance > 0)
      findings.Warning(sensor.line, sensor.element + " is " + Readable(distance, "m") +
                                        " off all that the file tells of link '" +
                                        drawn.vehicle.links[static_cast<std::size_t>(link)].name +
                                        "', which carries it: correct the link, or xyz, which is in metres and in the "
                                        "axes of its link");
  }
}

void LintInertias(const DrawnVehicle& drawn, FileFaults& findings) {
  // What a file does not show of a body lies within this.
  constexpr double kUnseen_m = 1;
  const BodyBoxes boxes(drawn);
  for (std::size_t i = 1; i < drawn.vehicle.links.size(); ++i) {
    const Link& link = drawn.vehicle.links[i];
    const double mass = drawn.At(link.mass);
    if (mass <= 0) continue;
    const double greatest = std::max({drawn.At(link.inertia[0]), drawn.At(link.inertia[1]), drawn.At(link.inertia[2])});
    const double radius = std::sqrt(greatest / mass);
    const Point com{static_cast<int>(i), link.ComAt(drawn.values)};
    const auto reach = [&](const Eigen::AlignedBox3d& box) {
      const Eigen::Vector3d place = drawn.Place(com);
      return (place - box.min()).cwiseAbs().cwiseMax((place - box.max()).cwiseAbs()).norm() + kUnseen_m;
    };
    if (radius <= reach(boxes.Of(com.link)) || radius <= reach(boxes.WithMeshes(com.link))) continue;
    findings.Warning(link.line, "inertia of " + Called("link", link.name) + " is " + Readable(greatest, "kg*m^2") +
                                    " at a mass of " + Readable(mass, "kg") + ", a radius of gyration of " +
                                    Readable(radius, "m") +
                                    ", beyond all that the file tells of the body: check the "
                                    "digits and units of both");
  }
}

void LintTyreHeights(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kLevel_m = 0.02;
  // Of a point that stands for the foot or, in models without roll, for the centre.
  constexpr double kLowest_m = -0.1;
  constexpr double kHighest_m = 1.5;
  for (const Tyre& tyre : drawn.vehicle.tyres) {
    const double height = drawn.Place(tyre.point).z();
    const std::string what = "the point of " + Called("fp:tyre", tyre.name) + " is " + Readable(height, "m") +
                             " above the platform, z = 0, in the design pose";
    if (tyre.radius > 0 && std::abs(height - tyre.radius) > kLevel_m)
      findings.Warning(tyre.source_line, what + ", but its radius is " + Readable(tyre.radius, "m") +
                                             ": correct the joint's origin, the point or the radius");
    if (tyre.radius == 0 && (height < kLowest_m || height > kHighest_m))
      findings.Warning(tyre.source_line, what + ": correct the joint's origin or the point");
  }
}

void LintLengths(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kShort_m = 0.02;
  constexpr double kLong_m = 3;
  const auto check = [&](const std::string& element, int line, const ForceLine& ends) {
    if (ends.axis) return;
    const double length = drawn.Length(ends);
    if (length >= kShort_m && length <= kLong_m) return;
    findings.Warning(line, element + " is " + Readable(length, "m") + " long in the design pose: " +
                               (length > kLong_m ? "correct its ends"
                                                 : "its direction turns with the least motion; correct its ends, or "
                                                   "give it an axis"));
  };
  for (const Spring& spring : drawn.vehicle.springs) check(spring.Element(), spring.source_line, spring.line);
  for (const Damper& damper : drawn.vehicle.dampers)
    check(Called("fp:damper", damper.name), damper.source_line, damper.line);
}

void LintPosts(const DrawnVehicle& drawn, FileFaults& findings) {
  const Vehicle& vehicle = drawn.vehicle;
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

void LintSensors(const DrawnVehicle& drawn, FileFaults& findings) {
  if (drawn.vehicle.sensors.empty())
    findings.Warning(0, "the vehicle has no sensor, so nothing of its response is seen: add fp:sensor tags");
}

}  // namespace fourpost
