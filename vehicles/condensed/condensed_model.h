#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vehicles/laws/dashpot_law.h"
#include "vehicles/laws/mounted_hydraulic_damper.h"
#include "vehicles/laws/spring_law.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// A vehicle with small motion s about static equilibrium, its n independent coordinates, posts p and sensors y:
///   mass s'' + damping s' + stiffness s + sum_j direction_j f_j = post_stiffness z + post_damping z'
///   y = on_position s + on_velocity s' + on_acceleration s''
///       + on_post_height z + on_post_velocity z' + on_post_acceleration z''
/// with f_j the tension of damper j at its extension rate direction_j . s', and what springs, tyres and hydraulic
/// dampers add where they depart from their linear share in the design pose.
struct CondensedModel {
  struct Dashpot {
    /// n; derivative of the damper's extension by s.
    Eigen::VectorXd direction;
    DashpotLaw law;
    /// In line with the dashpot; without stiffness: none.
    SpringLaw series;

    bool HasSeries() const { return series.stiffness > 0; }

    /// Middle of all slopes of the law [N s/m]: what the law departs from this rate by never exceeds half their range,
    /// so that taking it as linear and the rest as a remainder is a contraction.
    double CentreRate() const { return 0.5 * (law.LeastRate() + law.GreatestRate()); }
  };

  /// A spring with knees or a cubic term, or a stop. `stiffness` has its rate in the design pose, law.Slope(0).
  struct Stiffening {
    /// n; derivative of the spring's length by s.
    Eigen::VectorXd direction;
    SpringLaw law;
  };

  /// A hydraulic damper without its friction, with its mount. `stiffness` and `dashpots` have its linear share.
  struct Hydraulic {
    /// n; derivative of the extension of damper and mount by s.
    Eigen::VectorXd direction;
    MountedHydraulicDamper law;
    /// Index in `dashpots` of its linear share.
    std::size_t dashpot = 0;
  };

  /// A tyre that cannot pull: its compression preload + stiffness e + damping e' of the squeeze e = direction . s + z,
  /// z its post, counts where it is positive. The matrices have its linear law.
  struct Liftoff {
    /// n; derivative of the squeeze by s.
    Eigen::VectorXd direction;
    /// -1: on the ground.
    int post = -1;
    double preload = 0;    // N
    double stiffness = 0;  // N/m
    double damping = 0;    // N s/m
    /// Indices of the load cells under it.
    std::vector<int> load_cells;
  };

  /// n x n. `damping` holds all but the dashpots; `stiffness` holds rates and the effect of preloads and gravity.
  Eigen::MatrixXd mass;
  Eigen::MatrixXd damping;
  Eigen::MatrixXd stiffness;
  /// n x posts.
  Eigen::MatrixXd post_stiffness;
  Eigen::MatrixXd post_damping;
  std::vector<Dashpot> dashpots;
  std::vector<Stiffening> stiffenings;
  std::vector<Hydraulic> hydraulics;
  std::vector<Liftoff> liftoffs;

  /// sensors x n, sensors x posts.
  Eigen::MatrixXd on_position;
  Eigen::MatrixXd on_velocity;
  Eigen::MatrixXd on_acceleration;
  Eigen::MatrixXd on_post_height;
  Eigen::MatrixXd on_post_velocity;
  Eigen::MatrixXd on_post_acceleration;

  /// Forces that hold the vehicle in its design pose.
  Preloads preloads;

  /// The dashpots with a series spring, in file order; those of hydraulic dampers too.
  std::vector<const Dashpot*> SeriesDampers() const;
};

}  // namespace fourpost
