#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/design_shape.h"
#include "vehicles/description/element_laws.h"
#include "vehicles/description/scalar.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Geometry of a vehicle about its design pose and the laws of its elements, as plain numbers: all that a reduced model
/// at other values of the parameters needs. Condense() takes it from the multibody system, see ReducedVehicle for what
/// becomes of it. n: independent coordinates. Elements are in the vehicle's order.
struct ReducedData {
  /// A link. What depends on its centre of mass c is affine in it: value = [0] + c1 [1] + c2 [2] + c3 [3]; if no
  /// parameter moves c, [0] is the value and the only entry.
  struct Body {
    std::string name;
    Scalar mass;
    std::array<Scalar, 3> com;
    /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
    std::array<Scalar, 6> inertia;
    /// Of the centre of mass in ground axes [m], and its velocity per unit of the coordinates' rates, 3 x n.
    std::vector<Eigen::Vector3d> place;
    std::vector<Eigen::MatrixXd> com_jacobian;
    /// Angular velocity in link axes per unit of the coordinates' rates, 3 x n.
    Eigen::MatrixXd spin_jacobian;
    /// First and second derivative of the weight's potential by the coordinates, per unit mass.
    std::vector<Eigen::VectorXd> weight;
    std::vector<Eigen::MatrixXd> weight_stiffness;
  };

  /// An element that carries a force in the design pose: a spring, a tyre in the vertical, a translation of a bushing.
  struct Held {
    /// Of its length L: of a spring, minus the height of a tyre's foot or its position on the platform, a displacement
    /// of a bushing.
    DesignShape shape;
    SpringDescription law;
    std::optional<Scalar> preload;
    /// Instead of a preload: the law has no tension at this length.
    std::optional<Scalar> free_length;

    /// Otherwise equilibrium sets the preload.
    bool IsGiven() const { return preload || free_length; }
    double GivenAt(std::span<const double> parameters) const;
  };

  struct Tyre {
    Scalar damping;
    /// Instead of the held element's: a rate that changes with the load.
    std::optional<TyreDescription> curve;
    bool lifts_off = false;
    /// -1: on the ground.
    int post = -1;
  };

  /// A linear spring-damper along `direction`, unloaded in the design pose.
  struct Bond {
    Scalar stiffness;
    Scalar damping;
    /// Adds damping = loss_time stiffness [s].
    Scalar loss_time;
    Eigen::VectorXd direction;
  };

  struct Damper {
    Eigen::VectorXd direction;
    DashpotDescription law;
    std::optional<SpringDescription> series;
    std::optional<HydraulicDescription> hydraulic;
  };

  /// Of the vehicle.
  std::string name;
  /// Names, values, bounds and units.
  std::vector<Parameter> parameters;
  std::vector<std::string> posts;
  /// Names, types, and of load cells tyre and wheelpan.
  std::vector<Sensor> sensors;
  /// n.
  int coordinates = 0;
  std::vector<Body> bodies;
  /// Springs, tyres, then three translations of each bushing that holds.
  std::vector<Held> held;
  std::size_t springs = 0;
  std::vector<Tyre> tyres;
  /// Whether each bushing holds.
  std::vector<bool> bushings;
  std::vector<Bond> bonds;
  std::vector<Damper> dampers;
  /// n x actuators, see CondensedModel.
  Eigen::MatrixXd actuators;
  /// Sensors x n, see CondensedModel; those of load cells are zero.
  Eigen::MatrixXd on_position;
  Eigen::MatrixXd on_velocity;
  Eigen::MatrixXd on_acceleration;
};

}  // namespace fourpost
