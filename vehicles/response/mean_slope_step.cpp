#include "vehicles/response/mean_slope_step.h"

#include <complex>
#include <variant>

#include "analysis/numerics/decompositions.h"
#include "vehicles/response/port_cycle.h"

namespace fourpost {

MeanSlopeStep::MeanSlopeStep(const PortCycle& cycle) {
  const auto ports = static_cast<Eigen::Index>(cycle.ports().size());
  Eigen::VectorXd by_extension = Eigen::VectorXd::Zero(ports);
  Eigen::VectorXd by_rate = Eigen::VectorXd::Zero(ports);
  Eigen::MatrixXd slopes(cycle.samples(), 2);
  for (Eigen::Index j = 0; j < ports; ++j) {
    const PortLaw& law = cycle.ports()[static_cast<std::size_t>(j)].law;
    if (std::holds_alternative<HydraulicRemainder>(law)) continue;
    RemainderSlopes(law, Samples(cycle.extension_time(), j), Samples(cycle.rate_time(), j), Room(slopes, 0),
                    Room(slopes, 1));
    by_extension[j] = slopes.col(0).mean();
    by_rate[j] = slopes.col(1).mean();
  }
  for (Eigen::Index h = 0; h <= cycle.harmonics(); ++h) {
    const Eigen::MatrixXcd receptance = cycle.receptance().row(h).reshaped(ports, ports);
    Eigen::VectorXcd slope(ports);
    slope.real() = by_extension;
    slope.imag() = static_cast<double>(h) * cycle.omega() * by_rate;
    const Eigen::MatrixXcd unit = Eigen::MatrixXcd::Identity(ports, ports);
    const Eigen::MatrixXcd matrix = unit - receptance * slope.asDiagonal();
    inverses_.push_back(Solved(matrix, unit));
  }
}

Eigen::MatrixXcd MeanSlopeStep::Of(const Eigen::MatrixXcd& step) const {
  Eigen::MatrixXcd answer(step.rows(), step.cols());
  for (Eigen::Index h = 0; h < step.rows(); ++h)
    answer.row(h) = (inverses_[static_cast<std::size_t>(h)].lazyProduct(step.row(h).transpose())).transpose();
  return answer;
}

}  // namespace fourpost
