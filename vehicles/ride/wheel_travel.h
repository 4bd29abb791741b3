#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {

/// Motion of the suspension driven at its wheels, to first order.
struct WheelTravel {
  /// One per wheel: rise of its foot [m].
  Eigen::VectorXd rise;
  /// n; the independent coordinates.
  Eigen::VectorXd motion;
  /// One per wheel: upward force on it [N].
  Eigen::VectorXd force;
};

/// A vehicle with held chassis and wheels driven up and down by their feet, as on a kinematics and compliance rig with
/// floating pads: the tyres are vertically rigid and have no lateral and longitudinal rate. All other coordinates
/// follow in static equilibrium:
///   K s = C' f,  C s = (0, rise),
/// K: stiffness of the vehicle without the rates of its tyres; C: six motions of the chassis, rises of the feet; f:
/// forces that hold the chassis (none in the design pose) and move the wheels.
class HeldChassis {
 public:
  /// `stiffness`: of the reduced vehicle, with preloads and gravity, without the rates of the tyres.
  HeldChassis(const Suspension& suspension, Eigen::MatrixXd stiffness);

  /// For these rises of the feet, one per wheel [m]; empty if the wheels cannot move so, e.g. if one of two wheels that
  /// no joint lets move against each other must rise alone.
  std::optional<WheelTravel> Move(const Eigen::VectorXd& rise) const;
  std::optional<WheelTravel> MoveOne(std::size_t wheel) const;
  /// All wheels of the axle together.
  std::optional<WheelTravel> MoveTogether(const Axle& axle) const;
  std::optional<WheelTravel> MoveAll() const;
  /// Rise of each wheel of the axle = its distance to the left of the axle's middle: 1 rad of roll.
  std::optional<WheelTravel> Roll(const Axle& axle) const;

 private:
  std::vector<double> wheel_y_;
  Eigen::MatrixXd stiffness_;
  Eigen::MatrixXd constraints_;
  /// Columns span the motions that move neither chassis nor feet.
  Eigen::MatrixXd free_;
  // Decomposed once for all travels: C, free' K free, C'.
  LeastNorm leading_;
  LeastNorm yielding_;
  LeastNorm holding_;
};

/// The stiffness of the reduced vehicle without the rates of its tyres; the effect of their preloads is included.
Eigen::MatrixXd StiffnessWithoutTyres(const Vehicle& vehicle, const Kinematics& pose,
                                      std::span<const double> parameters, const CondensedModel& model);

}  // namespace fourpost
