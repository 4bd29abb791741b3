#pragma once

#include <array>

#include <Eigen/Core>

#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// A scalar of the geometry (a length, a height) in one pose and its derivative by the chosen coordinates.
struct Coordinate {
  double value = 0;
  Eigen::VectorXd gradient;
};

/// The geometry of a vehicle in one pose, differentiated by coordinates s with dq = tangent ds.
class Kinematics {
 public:
  /// `tangent`: joint coordinates x coordinates s. The multibody must already be in the intended pose.
  Kinematics(const Multibody& multibody, const Eigen::MatrixXd& tangent);
  /// By the joint coordinates themselves.
  explicit Kinematics(const Multibody& multibody);

  Coordinate LineLength(const ForceLine& line) const;
  /// Difference of the lengths of an anti-roll bar's lines, left - right.
  Coordinate Twist(const AntiRollBar& bar) const;
  /// Position of the child's point in the bushing's axes, then its turn, see Bushing. `child_axes`: of the child link,
  /// aligned with the bushing's axes in the design pose.
  std::array<Coordinate, 6> BushingPlace(const Bushing& bushing, const Eigen::Matrix3d& child_axes) const;
  /// Axes of the child link that are aligned with those of the bushing in this pose.
  Eigen::Matrix3d ChildAxes(const Bushing& bushing) const;
  /// Component along `direction` (ground axes) of the position of a tyre's foot.
  Coordinate FootPosition(const Tyre& tyre, const Eigen::Vector3d& direction) const;
  /// Component along `direction` (ground axes) of the point's position.
  Coordinate Position(const Point& point, const Eigen::Vector3d& direction) const;

  /// In ground axes.
  Eigen::Vector3d Location(const Point& point) const;
  Eigen::Matrix3d Rotation(int link) const;
  /// 3 x coordinates, ground axes: velocity of the point, and angular velocity of the link, per unit ds/dt.
  Eigen::MatrixXd PointJacobian(const Point& point) const;
  Eigen::MatrixXd AngularJacobian(int link) const;

 private:
  Eigen::Vector3d Arm(int link, const Eigen::Vector3d& place) const;
  /// Derivatives by s of the displacement of the link's point along a direction, and of the link's rotation about one.
  Eigen::VectorXd Along(int link, const Eigen::Vector3d& place, const Eigen::Vector3d& direction) const;
  Eigen::VectorXd About(int link, const Eigen::Vector3d& axis) const;

  std::vector<Eigen::Isometry3d> pose_;
  /// Per link: angular velocity and velocity of its origin, ground axes, per unit ds/dt.
  std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian_;
};

}  // namespace fourpost
