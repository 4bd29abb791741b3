#include "vehicles/loops/loop_pose.h"

#include <algorithm>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

Eigen::MatrixXd Identity(const Multibody& multibody) {
  const int n = multibody.coordinate_count();
  return Eigen::MatrixXd::Identity(n, n);
}

}  // namespace

Eigen::MatrixXd Unseen(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& columns) {
  const Eigen::MatrixXd seen = rows * columns;
  if (seen.size() == 0) return columns;
  const SingularValues svd = SingularValuesOf(seen, SingularValues::kRight);
  return columns * svd.right.rightCols(columns.cols() - (svd.values.array() > kStill).count());
}

LoopPose::LoopPose(const Multibody& multibody)
    : kinematics_(multibody, Identity(multibody)),
      closures_(multibody.loop_closures()),
      jacobian_(multibody.LoopJacobian()),
      space_(LoopSpaceOf(jacobian_)) {}

LoopSpace LoopPose::SpaceOf(const Indices& closures, Eigen::Index most_rank) const {
  Eigen::MatrixXd rows(0, coordinates());
  for (const std::size_t i : closures) {
    rows.conservativeResize(rows.rows() + closures_[i].rows, Eigen::NoChange);
    rows.bottomRows(closures_[i].rows) = jacobian_.middleRows(closures_[i].first_row, closures_[i].rows);
  }
  return LoopSpaceOf(rows, most_rank);
}

bool LoopPose::MoveTogether(int a, int b, const Eigen::MatrixXd& motions) const {
  if (motions.cols() == 0) return true;
  const Point origin_a{a, Eigen::Vector3d::Zero()};
  const Point origin_b{b, Eigen::Vector3d::Zero()};
  const Eigen::Vector3d arm = kinematics_.Location(origin_b) - kinematics_.Location(origin_a);
  const Point beside{a, kinematics_.Rotation(a).transpose() * arm};
  const Eigen::MatrixXd slide = (kinematics_.PointJacobian(origin_b) - kinematics_.PointJacobian(beside)) * motions;
  const Eigen::MatrixXd turn = (kinematics_.AngularJacobian(b) - kinematics_.AngularJacobian(a)) * motions;
  return std::max(slide.cwiseAbs().maxCoeff(), turn.cwiseAbs().maxCoeff()) <= kStill;
}

Eigen::MatrixXd LoopPose::Holding(int link, const Eigen::MatrixXd& motions) const {
  Eigen::MatrixXd rows(6, coordinates());
  rows << kinematics_.PointJacobian({link, Eigen::Vector3d::Zero()}), kinematics_.AngularJacobian(link);
  return Unseen(rows, motions);
}

}  // namespace fourpost
