#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "vehicles/description/drawn_vehicle.h"

namespace fourpost {

/// Extent of the bodies of a drawn vehicle, as far as its file describes them, as boxes in ground axes. A body is a
/// link with everything that fixed joints hold to it.
class BodyBoxes {
 public:
  /// `drawn` must outlive this object.
  explicit BodyBoxes(const DrawnVehicle& drawn);

  /// Box of the link's body: centres of mass, points of elements, rotating joints, boxes, cylinders and spheres. Empty
  /// if it has none of these.
  const Eigen::AlignedBox3d& Of(int link) const { return boxes_[Body(link)]; }
  /// Of() and the body's meshes; all of space if one of them is missing.
  Eigen::AlignedBox3d WithMeshes(int link) const;

 private:
  std::size_t Body(int link) const { return bodies_[static_cast<std::size_t>(link)]; }
  void Extend(const Point& point) { boxes_[Body(point.link)].extend(drawn_.Place(point)); }
  void AddShapes(std::size_t link);

  const DrawnVehicle& drawn_;
  /// For each link the first link of its body.
  std::vector<std::size_t> bodies_;
  /// By first link.
  std::vector<Eigen::AlignedBox3d> boxes_;
};

}  // namespace fourpost
