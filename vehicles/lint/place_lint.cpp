#include "vehicles/lint/place_lint.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "vehicles/description/body_box.h"
#include "vehicles/description/element_list.h"
#include "vehicles/lint/bench_vehicle.h"
#include "vehicles/lint/findings.h"

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
      findings.Report(
          kSensorOffBody, sensor.line,
          {sensor.element, Readable(distance, "m"), drawn.vehicle.links[static_cast<std::size_t>(link)].name});
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
    findings.Report(
        kInertiaUnusual, link.line,
        {Called("link", link.name), Readable(greatest, "kg*m^2"), Readable(mass, "kg"), Readable(radius, "m")});
  }
}

void LintTyreHeights(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kLevel_m = 0.02;
  // Of a point that stands for the foot or, in models without roll, for the centre.
  constexpr double kLowest_m = -0.1;
  constexpr double kHighest_m = 1.5;
  for (const Tyre& tyre : drawn.vehicle.tyres) {
    const double height = drawn.Place(tyre.point).z();
    const std::string name = Called("fp:tyre", tyre.name);
    if (tyre.radius > 0 && std::abs(height - tyre.radius) > kLevel_m)
      findings.Report(kTyreRadiusOff, tyre.source_line, {name, Readable(height, "m"), Readable(tyre.radius, "m")});
    if (tyre.radius == 0 && (height < kLowest_m || height > kHighest_m))
      findings.Report(kTyreHeight, tyre.source_line, {name, Readable(height, "m")});
  }
}

void LintLengths(const DrawnVehicle& drawn, FileFaults& findings) {
  constexpr double kShort_m = 0.02;
  constexpr double kLong_m = 3;
  const auto check = [&](const std::string& element, int line, const ForceLine& ends) {
    if (ends.axis) return;
    const double length = drawn.Length(ends);
    if (length >= kShort_m && length <= kLong_m) return;
    findings.Report(length > kLong_m ? kLineLong : kLineShort, line, {element, Readable(length, "m")});
  };
  for (const Spring& spring : drawn.vehicle.springs) check(spring.Element(), spring.source_line, spring.line);
  for (const Damper& damper : drawn.vehicle.dampers)
    check(Called("fp:damper", damper.name), damper.source_line, damper.line);
}

void LintPosts(const DrawnVehicle& drawn, FileFaults& findings) {
  const Vehicle& vehicle = drawn.vehicle;
  if (vehicle.posts.empty() && !vehicle.tyres.empty()) findings.Report(kPostsNone, 0);
  for (std::size_t i = 0; i < vehicle.tyres.size() && !vehicle.posts.empty(); ++i) {
    const bool has_post = std::any_of(vehicle.posts.begin(), vehicle.posts.end(),
                                      [&](const Post& post) { return post.tyre == static_cast<int>(i); });
    if (!has_post)
      findings.Report(kPostMissing, vehicle.tyres[i].source_line, {Called("fp:tyre", vehicle.tyres[i].name)});
  }
}

void LintSensors(const DrawnVehicle& drawn, FileFaults& findings) {
  if (drawn.vehicle.sensors.empty() && !IsBenchVehicle(drawn.vehicle)) findings.Report(kSensorsNone, 0);
}

}  // namespace fourpost
