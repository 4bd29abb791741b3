#pragma once

#include <vector>

#include <Eigen/Core>

#include "vehicles/dashpot_law.h"
#include "vehicles/multibody.h"

namespace fourpost {

/// A vehicle with small motion s about static equilibrium, its n independent coordinates, posts p and sensors y:
///   mass s'' + damping s' + stiffness s + sum_j direction_j f_j = post_stiffness z + post_damping z'
///   y = on_position s + on_velocity s' + on_acceleration s''
///       + on_post_height z + on_post_velocity z' + on_post_acceleration z''
/// with f_j the tension of damper j at its extension rate direction_j . s'.
struct CondensedModel {
  struct Dashpot {
    /// n; derivative of the damper's extension by s.
    Eigen::VectorXd direction;
    DashpotLaw law;
    /// [N/m]; 0 where the damper has no series spring.
    double series_stiffness = 0;

    /// Middle of all slopes of the law [N s/m]: what the law departs from this rate by never exceeds half their range,
    /// so that taking it as linear and the rest as a remainder is a contraction.
    double CentreRate() const { return 0.5 * (law.LeastRate() + law.GreatestRate()); }
  };

  /// n x n. `damping` holds all but the dashpots; `stiffness` holds rates and the effect of preloads and gravity.
  Eigen::MatrixXd mass;
  Eigen::MatrixXd damping;
  Eigen::MatrixXd stiffness;
  /// n x posts.
  Eigen::MatrixXd post_stiffness;
  Eigen::MatrixXd post_damping;
  std::vector<Dashpot> dashpots;

  /// sensors x n, sensors x posts.
  Eigen::MatrixXd on_position;
  Eigen::MatrixXd on_velocity;
  Eigen::MatrixXd on_acceleration;
  Eigen::MatrixXd on_post_height;
  Eigen::MatrixXd on_post_velocity;
  Eigen::MatrixXd on_post_acceleration;

  /// Forces that hold the vehicle in its design pose.
  Preloads preloads;

  /// The dashpots with a series spring, in file order.
  std::vector<const Dashpot*> SeriesDampers() const;
};

}  // namespace fourpost
