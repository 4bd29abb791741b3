#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/design_shape.h"
#include "vehicles/description/scalar.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// A link about the design pose: contribution of its mass, inertia and weight in the independent coordinates.
/// Everything except the mass matrix is affine in the centre of mass c: value = [0] + c1 [1] + c2 [2] + c3 [3]; if no
/// parameter moves c, [0] is the value and the only entry.
class CondensedBody {
 public:
  /// Points whose heights are needed: the centre of mass, or the origin and the ends of the link's unit vectors.
  static std::vector<Point> HeightPoints(const Link& link, int index);

  /// `heights`: shapes of the heights of HeightPoints(). `pose`: the design pose.
  CondensedBody(const Link& link, int index, const Kinematics& pose, std::span<const DesignShape> heights);

  const std::string& name() const { return name_; }
  const Scalar& mass() const { return mass_; }
  const std::array<Scalar, 3>& com() const { return com_; }
  bool has_fixed_com() const { return place_.size() == 1; }

  /// Derivative of the weight's potential by the coordinates, per unit mass, and by component k of the centre of mass.
  Eigen::VectorXd WeightPerMass(std::span<const double> parameters) const { return At(weight_, parameters); }
  const Eigen::VectorXd& WeightByCom(std::size_t k) const { return weight_[k + 1]; }

  /// Adds the link's contribution to both.
  void AddTo(std::span<const double> parameters, Eigen::MatrixXd& mass, Eigen::MatrixXd& stiffness) const;

  Eigen::Vector3d Place(std::span<const double> parameters) const { return At(place_, parameters); }
  Eigen::MatrixXd ComJacobian(std::span<const double> parameters) const { return At(com_jacobian_, parameters); }
  /// Angular velocity in link axes per unit of the coordinates' rates.
  const Eigen::MatrixXd& spin_jacobian() const { return spin_jacobian_; }
  /// Ixx, Iyy, Izz.
  Eigen::Vector3d Moments(std::span<const double> parameters) const;

 private:
  template <typename T>
  T At(const std::vector<T>& values, std::span<const double> parameters) const {
    T sum = values[0];
    for (std::size_t k = 1; k < values.size(); ++k) sum += com_[k - 1].At(parameters) * values[k];
    return sum;
  }

  std::string name_;
  Scalar mass_;
  std::array<Scalar, 3> com_;
  std::array<Scalar, 6> inertia_;
  std::vector<Eigen::Vector3d> place_;
  std::vector<Eigen::MatrixXd> com_jacobian_;
  Eigen::MatrixXd spin_jacobian_;
  /// Per unit mass, if the centre of mass is fixed.
  Eigen::MatrixXd mass_matrix_;
  /// Per unit Ixx .. Iyz.
  std::array<Eigen::MatrixXd, 6> inertia_matrix_;
  std::vector<Eigen::VectorXd> weight_;
  std::vector<Eigen::MatrixXd> weight_stiffness_;
};

}  // namespace fourpost
