#include "vehicles/templates/axle_knowledge.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace fourpost {

KnownBody KnownBody::operator+(const KnownBody& other) const {
  KnownBody sum{.mass = mass + other.mass};
  if (!(sum.mass > 0)) return sum;
  sum.com = (mass * com + other.mass * other.com) / sum.mass;
  for (const KnownBody* part : {this, &other}) {
    const Eigen::Vector3d arm = part->com - sum.com;
    sum.inertia +=
        part->inertia + part->mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  return sum;
}

KnownBody KnownBody::operator-(const KnownBody& hole) const {
  return *this + KnownBody{.mass = -hole.mass, .com = hole.com, .inertia = -hole.inertia};
}

KnownBody KnownBody::Mirrored() const {
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1, -1, 1).asDiagonal();
  return {.mass = mass, .com = mirror * com, .inertia = mirror * inertia * mirror};
}

KnownBody KnownBody::Possible() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  Eigen::Vector3d moments = solver.eigenvalues().cwiseMax(0);
  // A thousandth less than the sum, since moments are written as decimals.
  const double most = 0.999 * (moments[0] + moments[1]);
  if (moments[2] <= most) return *this;
  moments[2] = std::max(most, moments[1]);
  KnownBody possible = *this;
  possible.inertia = solver.eigenvectors() * moments.asDiagonal() * solver.eigenvectors().transpose();
  return possible;
}

}  // namespace fourpost
