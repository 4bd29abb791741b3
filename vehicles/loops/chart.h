#pragma once

#include <Eigen/Core>

#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Minimal coordinates s of a vehicle whose loop closures constrain its joint coordinates q: q(s) closes the loops and
/// N0' (q - q0) = s, where q0 is the design pose and the columns of N0 span the motions that the loops allow there.
/// Without loops s = q - q0.
class Chart {
 public:
  explicit Chart(Multibody& multibody);

  /// Number of independent coordinates: the vehicle's degrees of freedom.
  int size() const { return static_cast<int>(basis_.cols()); }

  /// Moves the multibody to the pose q(s) and returns dq/ds there, coordinates x size(). Throws FaultyInput, see
  /// LoopsCannotFollow, if the loops do not allow it.
  Eigen::MatrixXd MoveTo(const Eigen::VectorXd& s);

  /// The joint coordinates of a motion.
  struct Motion {
    Eigen::VectorXd q;
    Eigen::VectorXd rate;
    Eigen::VectorXd acceleration;
    /// dq/ds.
    Eigen::MatrixXd tangent;
  };
  /// Moves the multibody to time t and the state of this motion, with z appended. Throws as
  /// MoveTo.
  Motion Follow(double t, const Eigen::VectorXd& s, const Eigen::VectorXd& rate, const Eigen::VectorXd& acceleration,
                const Eigen::VectorXd& z);

 private:
  Eigen::VectorXd Close(const Eigen::VectorXd& s);

  Multibody& multibody_;
  Eigen::MatrixXd basis_;
  /// Also true for loops that remove no coordinate to first order, such as a rod in a singular pose.
  bool has_loops_ = false;
};

}  // namespace fourpost
