#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vehicles/laws/dahl_friction.h"
#include "vehicles/laws/dashpot_law.h"
#include "vehicles/laws/mounted_hydraulic_damper.h"
#include "vehicles/laws/spring_law.h"
#include "vehicles/laws/tyre_law.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Reduced model of a vehicle for small motion s about static equilibrium: n independent coordinates, posts z,
/// tensions a of actuators and sensors y,
///   mass s'' + damping s' + stiffness s + sum_j direction_j f_j = post_stiffness z + post_damping z' + actuators a
///   y = on_position s + on_velocity s' + on_acceleration s''
///       + on_post_height z + on_post_velocity z' + on_post_acceleration z''
/// f_j is the tension of damper j at its extension rate direction_j . s'. Springs, tyres and hydraulic dampers add the
/// nonlinear part of their forces about the design pose.
struct CondensedModel {
  struct Dashpot {
    /// n; derivative of the damper's extension by s.
    Eigen::VectorXd direction;
    DashpotLaw law;
    /// Spring in series with the dashpot; zero stiffness: none.
    SpringLaw series;

    bool HasSeries() const { return series.stiffness > 0; }

    /// Middle of all slopes of the law [N s/m]: the law's slope differs from this rate by at most half its range, so
    /// that fixed-point iteration on the nonlinear part of the force is a contraction.
    double CentreRate() const { return 0.5 * (law.LeastRate() + law.GreatestRate()); }
  };

  /// A spring with knees or a cubic term, or a stop. `stiffness` includes its rate in the design pose, law.Slope(0).
  struct Stiffening {
    /// n; derivative of the spring's length by s.
    Eigen::VectorXd direction;
    SpringLaw law;
  };

  /// A hydraulic damper without its friction, with its mount. `stiffness` and `dashpots` include its linear part.
  struct Hydraulic {
    /// n; derivative of the extension of damper and mount by s.
    Eigen::VectorXd direction;
    MountedHydraulicDamper law;
    /// Index in `dashpots` of its linear part.
    std::size_t dashpot = 0;
  };

  /// Friction that sticks; the matrices know nothing of it, as if it slid.
  struct Rubbing {
    /// n; derivative of the extension by s.
    Eigen::VectorXd direction;
    DahlFriction law;
  };

  /// A tyre that cannot pull: its vertical force preload + stiffness e + damping e', e = direction . s + z the
  /// deflection and z its post, counts only where it is positive. The matrices include its linear law.
  struct Liftoff {
    /// n; derivative of the deflection by s.
    Eigen::VectorXd direction;
    /// -1: on the ground.
    int post = -1;
    double preload = 0;    // N
    double stiffness = 0;  // N/m
    double damping = 0;    // N s/m
    /// Indices of the load cells under the tyre.
    std::vector<int> load_cells;
  };

  /// A tyre whose rate changes with its load, and which cannot pull: its vertical force law.Force(e) + damping e', e as
  /// of Liftoff, counts only where it is positive. The matrices include its rate at rest and its damping.
  struct CurvedTyre {
    /// n; derivative of the deflection by s.
    Eigen::VectorXd direction;
    /// -1: on the ground.
    int post = -1;
    LoadedTyre law;
    double damping = 0;  // N s/m
    /// Indices of the load cells under the tyre.
    std::vector<int> load_cells;
  };

  /// n x n. `damping` excludes the dashpots; `stiffness` includes rates and the effect of preloads and gravity.
  Eigen::MatrixXd mass;
  Eigen::MatrixXd damping;
  Eigen::MatrixXd stiffness;
  /// n x posts.
  Eigen::MatrixXd post_stiffness;
  Eigen::MatrixXd post_damping;
  /// n x actuators, force on s per tension; without columns: there are none.
  Eigen::MatrixXd actuators;
  std::vector<Dashpot> dashpots;
  std::vector<Stiffening> stiffenings;
  std::vector<Hydraulic> hydraulics;
  std::vector<Rubbing> rubbings;
  std::vector<Liftoff> liftoffs;
  std::vector<CurvedTyre> curved_tyres;

  /// sensors x n, sensors x posts.
  Eigen::MatrixXd on_position;
  Eigen::MatrixXd on_velocity;
  Eigen::MatrixXd on_acceleration;
  Eigen::MatrixXd on_post_height;
  Eigen::MatrixXd on_post_velocity;
  Eigen::MatrixXd on_post_acceleration;

  /// Forces that hold the vehicle in its design pose.
  Preloads preloads;

  /// Posts and actuators.
  Eigen::Index inputs() const { return post_stiffness.cols() + actuators.cols(); }

  /// The dashpots with a series spring, including those of hydraulic dampers, in file order.
  std::vector<const Dashpot*> SeriesDampers() const;

  /// The same with springs in place of friction that sticks: its linearisation about rest.
  CondensedModel Stuck() const;
};

}  // namespace fourpost
