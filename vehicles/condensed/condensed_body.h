#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/reduced_data.h"

namespace fourpost {

/// A link about the design pose: contribution of its mass, inertia and weight in the independent coordinates.
class CondensedBody {
 public:
  explicit CondensedBody(ReducedData::Body body);

  const ReducedData::Body& data() const { return body_; }
  bool has_fixed_com() const { return body_.place.size() == 1; }

  /// Derivative of the weight's potential by the coordinates, per unit mass, and by component k of the centre of mass.
  Eigen::VectorXd WeightPerMass(std::span<const double> parameters) const { return At(body_.weight, parameters); }
  const Eigen::VectorXd& WeightByCom(std::size_t k) const { return body_.weight[k + 1]; }

  /// Adds the link's contribution to both.
  void AddTo(std::span<const double> parameters, Eigen::MatrixXd& mass, Eigen::MatrixXd& stiffness) const;

  Eigen::Vector3d Place(std::span<const double> parameters) const { return At(body_.place, parameters); }
  Eigen::MatrixXd ComJacobian(std::span<const double> parameters) const { return At(body_.com_jacobian, parameters); }
  /// Ixx, Iyy, Izz.
  Eigen::Vector3d Moments(std::span<const double> parameters) const;

 private:
  template <typename T>
  T At(const std::vector<T>& values, std::span<const double> parameters) const {
    T sum = values[0];
    for (std::size_t k = 1; k < values.size(); ++k) sum += body_.com[k - 1].At(parameters) * values[k];
    return sum;
  }

  ReducedData::Body body_;
  /// Per unit mass, if the centre of mass is fixed.
  Eigen::MatrixXd mass_matrix_;
  /// Per unit Ixx .. Iyz.
  std::array<Eigen::MatrixXd, 6> inertia_matrix_;
};

}  // namespace fourpost
