#pragma once

#include <vector>

#include <Eigen/Core>

#include "vehicles/loops/loop_pose.h"
#include "vehicles/loops/motion_name.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// A singular pose: a motion that loop closures allow to first order but not to second order.
struct DeadCentre {
  NamedMotion motion;
  /// Closures whose equations forbid the motion to second order but allow it to first order.
  Indices closures;
};

/// Closures that take part in states of stress, in columns.
Indices Stressed(const Multibody& multibody, const Eigen::MatrixXd& stresses);

/// Singular motions of the design pose. Let N span the motions that the loop equations g(q) = 0 allow, and l' dg/dq = 0
/// be a state of stress. Along a path in N v the closures stay closed to second order if, for each l,
///   sum_i l_i (d2g_i/dq2)(N v, N v) = 0,
/// since the second-order part of dq contributes l' dg/dq = 0. Where the matrix of this form is not zero, N has more
/// motions than the neighbouring poses. `body`: the link relative to which motions are named if it can stand still.
/// Leaves the multibody in the design pose.
std::vector<DeadCentre> DeadCentres(Multibody& multibody, const LoopPose& design, int body);

}  // namespace fourpost
