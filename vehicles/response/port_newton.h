#pragma once

#include <Eigen/Core>

#include "vehicles/response/port_cycle.h"

namespace fourpost {

/// Derivatives of one port's harmonics R of the nonlinear force by those of its extension E, as coefficients of E and
/// of its conjugate.
struct PortCoupling {
  Eigen::Index port = 0;
  Eigen::MatrixXcd direct;
  Eigen::MatrixXcd conjugate;
};

/// For a port whose law has memory, for `size` harmonics from the mean on.
PortCoupling CycleCoupling(const PortCycle& cycle, const PortLaw& law, Eigen::Index port, Eigen::Index size);

/// Newton's step dE - receptance dR = step from the fixed-point iteration's `step`, (H + 1) x ports, for the ports
/// whose nonlinear forces change; the others follow, and so do the harmonics beyond the first `rows`.
Eigen::MatrixXcd NewtonStep(const PortCycle& cycle, const Eigen::MatrixXcd& step, Eigen::Index rows);

}  // namespace fourpost
