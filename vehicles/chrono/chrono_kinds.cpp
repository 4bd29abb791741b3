#include "vehicles/chrono/chrono_kinds.h"

#include <algorithm>
#include <array>

#include "vehicles/templates/axle_writer.h"

namespace fourpost {
namespace {

using Eigen::Vector3d;

void WriteGuidedAxle(AxleWriter& axle) {
  axle.Comment(
      "The axle moves up and down along the chassis and turns about its middle, as in Chrono, which has no links.");
  const Vector3d& centre = axle.points().At("wheel_centre");
  const Vector3d middle(centre.x(), 0, centre.z());
  axle.Central("guide", middle);
  axle.Body("guide", 0, {}, false);
  axle.Joint("guide", "body", "prismatic", middle, Vector3d::UnitZ(), false);
  axle.BeamAxleAt(middle);
  axle.Joint("axle", "guide", "continuous", middle, Vector3d::UnitX(), false);
  axle.Struts();
}

void WriteGuidedPanhard(AxleWriter& axle) {
  axle.Comment(
      "The axle moves in a plane across the chassis, as in Chrono, which has no trailing links; the Panhard rod\n"
      "       locates it sideways.");
  axle.BeamAxleAt(Vector3d::Zero());
  axle.Joint("axle", "body", "planar", Vector3d::Zero(), Vector3d::UnitX(), false);
  axle.Rod("panhard_rod", "panhard_body", "panhard_axle", "axle");
  axle.Struts();
}

/// The points of another kind but those that begin with one of these.
std::vector<PointSpec> Without(const SuspensionKind& kind, const std::vector<std::string_view>& beginnings) {
  std::vector<PointSpec> points;
  for (const PointSpec& point : kind.points)
    if (std::none_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return point.name.starts_with(beginning); }))
      points.push_back(point);
  return points;
}

std::array<SuspensionKind, 2> Kinds() {
  const SuspensionKind& linked = *FindSuspensionKind("four_link_panhard");
  return {SuspensionKind{.name = "guided_axle",
                         .summary = "beam axle that moves along the chassis",
                         .is_beam = true,
                         .points = Without(linked, {"lower_", "upper_", "panhard_"}),
                         .write = WriteGuidedAxle},
          SuspensionKind{.name = "guided_panhard",
                         .summary = "beam axle that moves across the chassis, with a Panhard rod",
                         .is_beam = true,
                         .points = Without(linked, {"lower_", "upper_"}),
                         .write = WriteGuidedPanhard}};
}

}  // namespace

const SuspensionKind* FindChronoKind(std::string_view name) {
  static const std::array<SuspensionKind, 2> kinds = Kinds();
  for (const SuspensionKind& kind : kinds)
    if (kind.name == name) return &kind;
  return FindSuspensionKind(name);
}

}  // namespace fourpost
