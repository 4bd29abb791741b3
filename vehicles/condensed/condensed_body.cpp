#include "vehicles/condensed/condensed_body.h"

#include <algorithm>
#include <utility>

#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

/// Mass matrices per unit of each inertia component, in the order of Link::inertia.
std::array<Eigen::MatrixXd, 6> InertiaMatrices(const Eigen::MatrixXd& spin) {
  constexpr std::array<std::pair<int, int>, 6> kComponents = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  std::array<Eigen::MatrixXd, 6> matrices;
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    Eigen::Matrix3d unit = Eigen::Matrix3d::Zero();
    unit(kComponents[k].first, kComponents[k].second) = 1;
    unit(kComponents[k].second, kComponents[k].first) = 1;
    matrices[k] = spin.transpose() * unit * spin;
  }
  return matrices;
}

bool IsMovable(const Link& link) {
  return std::any_of(link.com.begin(), link.com.end(), [](const Scalar& number) { return number.parameter >= 0; });
}

/// Values at the origin and at the ends of the unit vectors become the affine function's.
template <typename T>
void MakeAffine(std::vector<T>& values) {
  for (std::size_t k = 1; k < values.size(); ++k) values[k] -= values[0];
}

}  // namespace

std::vector<Point> CondensedBody::HeightPoints(const Link& link, int index) {
  if (!IsMovable(link)) return {{index, link.ComAt({})}};
  return {{index, Eigen::Vector3d::Zero()},
          {index, Eigen::Vector3d::UnitX()},
          {index, Eigen::Vector3d::UnitY()},
          {index, Eigen::Vector3d::UnitZ()}};
}

CondensedBody::CondensedBody(const Link& link, int index, const Kinematics& pose, std::span<const DesignShape> heights)
    : name_(link.name),
      mass_(link.mass),
      com_(link.com),
      inertia_(link.inertia),
      spin_jacobian_(pose.Rotation(index).transpose() * pose.AngularJacobian(index)),
      inertia_matrix_(InertiaMatrices(spin_jacobian_)) {
  for (const Point& point : HeightPoints(link, index)) {
    place_.push_back(pose.Location(point));
    com_jacobian_.push_back(pose.PointJacobian(point));
  }
  for (const DesignShape& height : heights) {
    weight_.emplace_back(kGravity * height.gradient);
    weight_stiffness_.emplace_back(kGravity * height.curvature);
  }
  MakeAffine(place_);
  MakeAffine(com_jacobian_);
  MakeAffine(weight_);
  MakeAffine(weight_stiffness_);
  if (has_fixed_com()) mass_matrix_ = com_jacobian_[0].transpose() * com_jacobian_[0];
}

void CondensedBody::AddTo(std::span<const double> parameters, Eigen::MatrixXd& mass, Eigen::MatrixXd& stiffness) const {
  if (const double m = mass_.At(parameters); m != 0) {
    if (has_fixed_com()) {
      mass += m * mass_matrix_;
      stiffness += m * weight_stiffness_[0];
    } else {
      const Eigen::MatrixXd jacobian = ComJacobian(parameters);
      mass += m * (jacobian.transpose() * jacobian);
      stiffness += m * At(weight_stiffness_, parameters);
    }
  }
  for (std::size_t k = 0; k < inertia_.size(); ++k)
    if (const double inertia = inertia_[k].At(parameters); inertia != 0) mass += inertia * inertia_matrix_[k];
}

Eigen::Vector3d CondensedBody::Moments(std::span<const double> parameters) const {
  return {inertia_[0].At(parameters), inertia_[1].At(parameters), inertia_[2].At(parameters)};
}

}  // namespace fourpost
