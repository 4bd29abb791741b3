#pragma once

#include <Eigen/Core>

#include "vehicles/response/port_cycle.h"

namespace fourpost {

/// Derivatives of the remainder's harmonics R by those of the extension E of one port, as coefficients of E and of its
/// conjugate.
struct PortCoupling {
  Eigen::Index port = 0;
  Eigen::MatrixXcd direct;
  Eigen::MatrixXcd conjugate;
};

/// Of a port whose law has memory, for `size` harmonics from the mean on.
PortCoupling CycleCoupling(const PortCycle& cycle, const HydraulicRemainder& law, Eigen::Index port, Eigen::Index size);

/// Newton's step dE - receptance dR = step from the plain iteration's `step`, (H + 1) x ports, for the ports whose
/// remainders change; the others follow, and so do the harmonics beyond the first `rows`.
Eigen::MatrixXcd NewtonStep(const PortCycle& cycle, const Eigen::MatrixXcd& step, Eigen::Index rows);

}  // namespace fourpost
