#include "vehicles/loops/dead_centre.h"

#include <algorithm>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

/// [1/m]: a point that stays straight to a radius of a hundred kilometres.
constexpr double kStraight = 1e-5;

/// Per state of stress: the form of second derivatives along the motions.
std::vector<Eigen::MatrixXd> Bends(Multibody& multibody, const Eigen::MatrixXd& stresses,
                                   const Eigen::MatrixXd& motions) {
  // Truncation kStep^2 / length^3 stays below 1e-6 for links of 0.1 m, rounding eps / kStep below 1e-10.
  constexpr double kStep = 1e-5;
  std::vector<Eigen::MatrixXd> bends(static_cast<std::size_t>(stresses.cols()),
                                     Eigen::MatrixXd(motions.cols(), motions.cols()));
  const auto jacobian_at = [&](const Eigen::VectorXd& step) {
    multibody.SetPose(multibody.design_pose() + step);
    return multibody.LoopJacobian();
  };
  for (Eigen::Index j = 0; j < motions.cols(); ++j) {
    const Eigen::VectorXd step = kStep * motions.col(j);
    const Eigen::MatrixXd change = (jacobian_at(step) - jacobian_at(-step)) / (2 * kStep);
    for (std::size_t k = 0; k < bends.size(); ++k)
      bends[k].col(j) = motions.transpose() * change.transpose() * stresses.col(static_cast<Eigen::Index>(k));
  }
  multibody.SetPose(multibody.design_pose());
  return bends;
}

/// Motions that some bend sees, as combinations of those it was made for.
Eigen::MatrixXd Bent(const std::vector<Eigen::MatrixXd>& bends, Eigen::Index motions) {
  Eigen::MatrixXd all(motions, 0);
  for (const Eigen::MatrixXd& bend : bends) {
    all.conservativeResize(Eigen::NoChange, all.cols() + bend.cols());
    all.rightCols(bend.cols()) = bend;
  }
  if (all.size() == 0) return {motions, 0};
  const SingularValues svd = SingularValuesOf(all, SingularValues::kLeft);
  return svd.left.leftCols((svd.values.array() > kStraight).count());
}

/// The state of stress that a motion meets; all of them where it meets none by itself, but only with other motions.
Eigen::MatrixXd Met(const std::vector<Eigen::MatrixXd>& bends, const Eigen::MatrixXd& stresses,
                    const Eigen::VectorXd& motion) {
  Eigen::VectorXd met = Eigen::VectorXd::Zero(stresses.rows());
  for (std::size_t k = 0; k < bends.size(); ++k)
    met += motion.dot(bends[k] * motion) * stresses.col(static_cast<Eigen::Index>(k));
  if (met.norm() <= kStraight * motion.squaredNorm()) return stresses;
  return met.normalized();
}

}  // namespace

Indices Stressed(const Multibody& multibody, const Eigen::MatrixXd& stresses) {
  Indices closures;
  const std::vector<LoopClosure>& all = multibody.loop_closures();
  for (std::size_t i = 0; i < all.size() && stresses.cols() > 0; ++i)
    if (stresses.middleRows(all[i].first_row, all[i].rows).cwiseAbs().maxCoeff() > kStill) closures.push_back(i);
  return closures;
}

std::vector<DeadCentre> DeadCentres(Multibody& multibody, const LoopPose& design, int body) {
  const Eigen::MatrixXd& stresses = design.space().stresses;
  const std::vector<LinkMotion> links = LinkMotionsOf(multibody.vehicle(), design.kinematics());
  std::vector<DeadCentre> found;
  // With the body at rest the motions are those of the suspension alone.
  for (const Eigen::MatrixXd& motions : {design.Holding(body, design.space().motions), design.space().motions}) {
    const std::vector<Eigen::MatrixXd> bends = Bends(multibody, stresses, motions);
    for (NamedMotion& motion : NameMotions(links, motions * Bent(bends, motions.cols()))) {
      const Eigen::MatrixXd met = Met(bends, stresses, motions.transpose() * motion.shape);
      found.push_back({.motion = std::move(motion), .closures = Stressed(multibody, met)});
    }
    if (!found.empty()) break;
  }
  return found;
}

}  // namespace fourpost
