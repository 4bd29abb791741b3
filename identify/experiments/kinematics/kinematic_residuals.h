#pragma once

#include <memory>

#include <Eigen/Core>

#include "identify/experiments/kinematics/kinematic_model.h"
#include "identify/residuals/residual_block.h"

namespace fourpost {

/// (modelled - measured) / sd of each point. Of a curve with a free offset one less: orthonormal contrasts
///   c_k = (r_1 + ... + r_k - k r_(k+1)) / sqrt(k (k + 1)),
/// whose squares sum to those of r about its mean (Helmert, 1876); white noise stays white.
Eigen::VectorXd CurveResiduals(const KinematicCurve& curve, const Eigen::VectorXd& modelled);

/// Of all sweeps. Infeasible where the suspension cannot go as far.
ResidualBlock KinematicResiduals(std::shared_ptr<const KinematicModel> model);

}  // namespace fourpost
