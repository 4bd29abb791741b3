#include "vehicles/loops/wheel_ride.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/description/chassis.h"

namespace fourpost {
namespace {

/// The column space, orthonormal.
Eigen::MatrixXd Range(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return {matrix.rows(), 0};
  const SingularValues svd = SingularValuesOf(matrix, SingularValues::kLeft);
  return svd.left.leftCols((svd.values.array() > kStill).count());
}

/// How high the points go with each motion.
Eigen::MatrixXd Heights(const LoopPose& pose, const std::vector<Point>& points, const Eigen::MatrixXd& motions) {
  Eigen::MatrixXd heights(points.size(), motions.cols());
  for (std::size_t i = 0; i < points.size(); ++i)
    heights.row(static_cast<Eigen::Index>(i)) = pose.kinematics().PointJacobian(points[i]).row(2) * motions;
  return heights;
}

}  // namespace

WheelRide::WheelRide(const Vehicle& vehicle, const LoopPose& design) {
  for (const Tyre& tyre : vehicle.tyres) centres_[CarrierOf(vehicle, design, tyre)].push_back(tyre.point);
  const std::vector<double> values = vehicle.ParameterValues();
  std::vector<TyreCarrier> links;
  for (const Link& link : vehicle.links) links.push_back({.mass = link.mass.At(values), .stations = {}});
  for (const auto& [link, centres] : centres_)
    for (const Point& centre : centres)
      links[static_cast<std::size_t>(link)].stations.push_back(design.kinematics().Location(centre).x());
  body_ = std::max(ChassisOf(links), 0);
}

int WheelRide::CarrierOf(const Vehicle& vehicle, const LoopPose& design, const Tyre& tyre) const {
  constexpr double kOnAxis_m = 1e-6;  // digits of a file
  const Kinematics& place = design.kinematics();
  int link = tyre.point.link;
  // Children before parents.
  for (auto joint = vehicle.joints.rbegin(); joint != vehicle.joints.rend(); ++joint) {
    if (joint->child != link || joint->parent == 0) continue;
    const Eigen::Vector3d arm = place.Location(tyre.point) - place.Location({link, Eigen::Vector3d::Zero()});
    const Eigen::Vector3d axis = place.Rotation(link) * joint->axis;
    const bool spins = joint->type == Joint::Type::kRevolute && axis.cross(arm).norm() < kOnAxis_m;
    if (joint->type == Joint::Type::kFixed || spins) link = joint->parent;
  }
  return link;
}

std::string WheelRide::LostBy(const LoopPose& pose, int link, const Eigen::MatrixXd& motions) const {
  const std::vector<Point>& centres = centres_.at(link);
  const Eigen::MatrixXd tree = pose.SpaceOf({}).motions;
  const Eigen::MatrixXd all = Range(Heights(pose, centres, pose.Holding(body_, tree)));
  const Eigen::MatrixXd left = Range(Heights(pose, centres, pose.Holding(body_, motions)));
  if (left.cols() >= all.cols()) return "";
  const Eigen::MatrixXd lost = all - left * (left.transpose() * all);
  return Word(pose, centres, SingularValuesOf(lost, SingularValues::kLeft).left.col(0));
}

/// Names heights of the points.
std::string WheelRide::Word(const LoopPose& pose, const std::vector<Point>& centres,
                            const Eigen::VectorXd& lost) const {
  Eigen::MatrixXd places(lost.size(), 3);
  for (Eigen::Index i = 0; i < lost.size(); ++i)
    places.row(i) = pose.kinematics().Location(centres[static_cast<std::size_t>(i)]);
  const Eigen::RowVector3d slope = lost.transpose() * (places.rowwise() - places.colwise().mean());
  if (std::abs(lost.mean()) >= slope.head<2>().cwiseAbs().maxCoeff()) return "heave";
  return std::abs(slope.y()) >= std::abs(slope.x()) ? "roll" : "pitch";
}

}  // namespace fourpost
