#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed_model.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// The geometry of a vehicle about its design pose, taken once from its multibody system, so that a model for other
/// masses, inertias, rates and laws costs microseconds and no Simbody.
///
/// Preloads follow from equilibrium, hence all matrices are linear in masses, inertias and rates:
///   mass      = sum over links of m J'J + W' I W,
///   stiffness = sum k b b' (b = dL/ds) + preloads times the second derivatives of their lengths
///               + sum m g times the second derivatives of the heights of the centres of mass.
/// Immutable after construction; one object serves any number of threads.
class CondensedVehicle {
 public:
  /// Throws FaultyInput when the loops cannot be assembled, when nothing can move, or when weights and given preloads
  /// have no static equilibrium in the design pose, at the file's values or within the bounds of its parameters (names
  /// the elements).
  explicit CondensedVehicle(const Vehicle& vehicle);

  /// Degrees of freedom.
  int size() const { return size_; }

  /// `parameters`: SI, in the order of Vehicle::parameters; here and below, any other number of them throws
  /// std::invalid_argument.
  CondensedModel At(std::span<const double> parameters) const;

  Preloads PreloadsAt(std::span<const double> parameters) const;

  /// A link with mass, and how it moves per unit of the independent coordinates.
  struct LinkMotion {
    std::string name;
    double mass = 0;
    /// Principal moments as if the axes were principal: Ixx, Iyy, Izz.
    Eigen::Vector3d inertia;
    /// Centre of mass in ground axes, design pose [m].
    Eigen::Vector3d com;
    /// 3 x n: velocity of the centre of mass (ground axes) and angular velocity (link axes).
    Eigen::MatrixXd com_jacobian;
    Eigen::MatrixXd spin_jacobian;
  };
  std::vector<LinkMotion> LinkMotions(std::span<const double> parameters) const;

 private:
  struct Body {
    std::string name;
    Scalar mass;
    std::array<Scalar, 6> inertia;
    Eigen::Vector3d com;
    Eigen::MatrixXd com_jacobian;
    Eigen::MatrixXd spin_jacobian;
    Eigen::MatrixXd mass_matrix;                    // per unit mass
    std::array<Eigen::MatrixXd, 6> inertia_matrix;  // per unit Ixx .. Iyz
    Eigen::VectorXd weight;                         // derivative of the potential by s, per unit mass
    Eigen::MatrixXd weight_stiffness;               // second derivative
  };
  struct Stiff {
    Scalar stiffness;
    Eigen::VectorXd direction;
    Eigen::MatrixXd curvature;
    std::optional<Scalar> preload;
    int unknown = -1;  // index among the preloads that equilibrium sets
  };
  struct Tyred : Stiff {
    Scalar damping;
    int post = -1;
  };
  struct Damped {
    Eigen::VectorXd direction;
    Scalar compression;
    Scalar rebound;
    std::optional<Scalar> series_stiffness;
  };

  void SolvePreloads(const Vehicle& vehicle);
  Eigen::VectorXd Weight(std::span<const double> parameters) const;

  int size_ = 0;
  std::size_t parameter_count_ = 0;
  Eigen::Index post_count_ = 0;
  std::vector<Body> bodies_;
  std::vector<Stiff> springs_;
  /// direction and curvature are those of the tyre's compression: minus its height.
  std::vector<Tyred> tyres_;
  std::vector<Damped> dampers_;
  /// Preloads that equilibrium sets = preload_map_ times the generalised weight.
  Eigen::MatrixXd preload_map_;
  /// Sensor rows that do not depend on parameters; load cells are filled in per model.
  CondensedModel sensors_;
  std::vector<std::pair<Eigen::Index, int>> load_cells_;  // sensor, tyre
};

}  // namespace fourpost
