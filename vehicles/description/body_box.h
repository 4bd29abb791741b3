#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "vehicles/description/drawn_vehicle.h"

namespace fourpost {

/// How far the bodies of a drawn vehicle reach as far as its file tells, as boxes in ground axes. A body is a link with
/// all that fixed joints hold to it.
class BodyBoxes {
 public:
  /// `drawn` must outlive this object.
  explicit BodyBoxes(const DrawnVehicle& drawn);

  /// Of the body that the link belongs to: its centres of mass, points of elements, joints that turn, boxes, cylinders
  /// and spheres. Empty where it has none of these.
  const Eigen::AlignedBox3d& Of(int link) const { return boxes_[Body(link)]; }
  /// That and the body's meshes; all of space where one of them is missing.
  Eigen::AlignedBox3d WithMeshes(int link) const;

 private:
  std::size_t Body(int link) const { return bodies_[static_cast<std::size_t>(link)]; }
  void Extend(const Point& point) { boxes_[Body(point.link)].extend(drawn_.Place(point)); }
  void AddShapes(std::size_t link);

  const DrawnVehicle& drawn_;
  /// Of each link the first link of its body.
  std::vector<std::size_t> bodies_;
  /// By first link.
  std::vector<Eigen::AlignedBox3d> boxes_;
};

}  // namespace fourpost
