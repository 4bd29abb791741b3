#include "vehicles/condensed/condensed_body.h"

#include <utility>

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

}  // namespace

CondensedBody::CondensedBody(ReducedData::Body body)
    : body_(std::move(body)), inertia_matrix_(InertiaMatrices(body_.spin_jacobian)) {
  if (has_fixed_com()) mass_matrix_ = body_.com_jacobian[0].transpose() * body_.com_jacobian[0];
}

void CondensedBody::AddTo(std::span<const double> parameters, Eigen::MatrixXd& mass, Eigen::MatrixXd& stiffness) const {
  if (const double m = body_.mass.At(parameters); m != 0) {
    if (has_fixed_com()) {
      mass += m * mass_matrix_;
      stiffness += m * body_.weight_stiffness[0];
    } else {
      const Eigen::MatrixXd jacobian = ComJacobian(parameters);
      mass += m * (jacobian.transpose() * jacobian);
      stiffness += m * At(body_.weight_stiffness, parameters);
    }
  }
  for (std::size_t k = 0; k < body_.inertia.size(); ++k)
    if (const double inertia = body_.inertia[k].At(parameters); inertia != 0) mass += inertia * inertia_matrix_[k];
}

Eigen::Vector3d CondensedBody::Moments(std::span<const double> parameters) const {
  return {body_.inertia[0].At(parameters), body_.inertia[1].At(parameters), body_.inertia[2].At(parameters)};
}

}  // namespace fourpost
