#include "vehicles/description/body_box.h"

#include <limits>
#include <optional>
#include <stdexcept>

#include "vehicles/description/element_list.h"
#include "vehicles/shapes/mesh.h"

namespace fourpost {
namespace {

using Box = Eigen::AlignedBox3d;

Box Around(const Eigen::Vector3d& half) { return {-half, half}; }

/// In the shape's axes.
Box BoxOf(const Visual& visual) {
  switch (visual.shape) {
    case Visual::Shape::kMesh: return {};
    case Visual::Shape::kBox: return Around(0.5 * visual.size);
    case Visual::Shape::kCylinder: return Around(visual.size.cwiseProduct(Eigen::Vector3d(1, 1, 0.5)));
    case Visual::Shape::kSphere: return Around(visual.size);
  }
  return {};
}

/// Nothing of a mesh that is missing.
std::optional<Box> MeshBoxOf(const Visual& visual) {
  try {
    const Box bounds = ReadMesh(visual.mesh_file).Bounds();
    Box scaled(bounds.min().cwiseProduct(visual.size).eval());
    return scaled.extend(bounds.max().cwiseProduct(visual.size).eval());
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

Box Placed(const Box& box, const Eigen::Isometry3d& pose) { return box.isEmpty() ? box : box.transformed(pose); }

}  // namespace

BodyBoxes::BodyBoxes(const DrawnVehicle& drawn)
    : drawn_(drawn), bodies_(drawn.vehicle.links.size()), boxes_(drawn.vehicle.links.size()) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i] = i;
  // Parents before children.
  for (const Joint& joint : drawn.vehicle.joints)
    if (joint.type == Joint::Type::kFixed) bodies_[static_cast<std::size_t>(joint.child)] = Body(joint.parent);
  for (const ElementPoint& item : PointsOf(drawn.vehicle)) Extend(item.point);
  for (const Joint& joint : drawn.vehicle.joints) {
    if (joint.type != Joint::Type::kRevolute) continue;
    Extend({joint.parent, joint.pose.translation()});
    Extend({joint.child, Eigen::Vector3d::Zero()});
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) AddShapes(i);
}

void BodyBoxes::AddShapes(std::size_t link) {
  for (const Visual& visual : drawn_.vehicle.links[link].visuals)
    boxes_[bodies_[link]].extend(Placed(BoxOf(visual), drawn_.poses[link] * visual.pose));
}

Eigen::AlignedBox3d BodyBoxes::WithMeshes(int link) const {
  Box box = Of(link);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i] != Body(link)) continue;
    for (const Visual& visual : drawn_.vehicle.links[i].visuals) {
      if (visual.shape != Visual::Shape::kMesh) continue;
      const std::optional<Box> mesh = MeshBoxOf(visual);
      if (!mesh) return Around(Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()));
      box.extend(Placed(*mesh, drawn_.poses[i] * visual.pose));
    }
  }
  return box;
}

}  // namespace fourpost
