// Loop closures against the joints that they stand in for.
#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "tests/vehicles/element_car.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/loops/chart.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost::welds_and_hinges_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The poles of a vehicle's linear model, by rising imaginary part.
VectorXd Poles(const Vehicle& vehicle) {
  const Eigen::EigenSolver<MatrixXd> solver(StateMatrix(CondensedVehicle(vehicle).At(vehicle.ParameterValues())),
                                            false);
  std::vector<double> sizes;
  for (const std::complex<double>& pole : solver.eigenvalues()) sizes.push_back(std::abs(pole));
  std::sort(sizes.begin(), sizes.end());
  return Eigen::Map<VectorXd>(sizes.data(), static_cast<Index>(sizes.size()));
}

Joint& JointOf(Vehicle& vehicle, const std::string& name) {
  for (Joint& joint : vehicle.joints)
    if (joint.name == name) return joint;
  throw std::invalid_argument(name);
}

// The wheel on its arm and the other arm on its pivot, as joints of the tree.
TEST(WeldsAndHinges, EqualJointsOfTheTree) {
  const Vehicle loops = ElementCar();
  Vehicle tree = loops;
  Joint& hub = JointOf(tree, "j_hub");
  hub.type = Joint::Type::kFixed;
  hub.parent = loops.welds[0].parent.link;
  hub.pose.translation() = loops.welds[0].parent.xyz;
  Joint& pivot = JointOf(tree, "j_hinged");
  pivot.type = Joint::Type::kRevolute;
  pivot.parent = loops.hinges[0].parent.link;
  pivot.pose.translation() = loops.hinges[0].parent.xyz;
  pivot.axis = loops.hinges[0].axis;
  // Parents before children.
  std::stable_partition(tree.joints.begin(), tree.joints.end(),
                        [&](const Joint& joint) { return joint.name != "j_hub" && joint.name != "j_hinged"; });
  tree.welds.clear();
  tree.hinges.clear();
  // Second derivatives along the loop's closed poses: 1e-10 of the lengths, see Chart.
  const VectorXd poles = Poles(loops);
  EXPECT_LT(((Poles(tree) - poles).array() / poles.array()).abs().maxCoeff(), 1e-8);
  const Preloads with_loops = CondensedVehicle(loops).PreloadsAt(loops.ParameterValues());
  const Preloads with_joints = CondensedVehicle(tree).PreloadsAt(tree.ParameterValues());
  for (std::size_t i = 0; i < with_loops.tyre.size(); ++i)
    EXPECT_NEAR(with_loops.tyre[i], with_joints.tyre[i], 1e-8);  // rounding of 10 kN
}

TEST(WeldsAndHinges, MoveAsJointsOfTheTree) {
  const Vehicle loops = ElementCar();
  Multibody multibody(loops);
  Chart chart(multibody);
  const Matrix3d hub = multibody.LinkPose(loops.welds[0].child.link).linear();
  const Matrix3d arm = multibody.LinkPose(loops.welds[0].parent.link).linear();
  for (int draw = 0; draw < 5; ++draw) {
    VectorXd s(chart.size());
    for (Index i = 0; i < s.size(); ++i) s[i] = 0.05 * std::sin(1.0 + draw + 1.3 * static_cast<double>(i));
    chart.MoveTo(s);
    const auto pose = [&](int link) { return multibody.LinkPose(link); };
    const auto gap = [&](const Point& a, const Point& b) {
      return (pose(a.link) * a.xyz - pose(b.link) * b.xyz).norm();
    };
    // What Chart leaves of a closed loop.
    constexpr double kClosed = 1e-12;
    for (const Weld& weld : loops.welds) {
      EXPECT_LT(gap(weld.parent, weld.child), kClosed);
      const Matrix3d turn = pose(weld.parent.link).linear().transpose() * pose(weld.child.link).linear();
      EXPECT_LT((turn - arm.transpose() * hub).norm(), kClosed);
    }
    for (const Hinge& hinge : loops.hinges) {
      EXPECT_LT(gap(hinge.parent, hinge.child), kClosed);
      // Both links were unturned.
      EXPECT_LT((pose(hinge.parent.link).linear() * hinge.axis - pose(hinge.child.link).linear() * hinge.axis).norm(),
                kClosed);
    }
    for (const Ball& ball : loops.balls) EXPECT_LT(gap(ball.parent, ball.child), kClosed);
  }
}

}  // namespace
}  // namespace fourpost::welds_and_hinges_test
