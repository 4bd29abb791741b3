#include "vehicles/response/mean_slope_step.h"

#include <cmath>
#include <complex>
#include <variant>

#include "analysis/numerics/decompositions.h"
#include "vehicles/response/port_cycle.h"

namespace fourpost {

MeanSlopeStep::MeanSlopeStep(const PortCycle& cycle) {
  std::vector<double> by_extension;
  std::vector<double> by_rate;
  Eigen::MatrixXd slopes(cycle.samples(), 2);
  const auto ports = static_cast<Eigen::Index>(cycle.ports().size());
  for (Eigen::Index j = 0; j < ports; ++j) {
    const PortLaw& law = cycle.ports()[static_cast<std::size_t>(j)].law;
    if (HasMemory(law)) continue;
    if (!UsesExtension(law) && !std::isfinite(StepOfRate(law))) continue;
    RemainderSlopes(law, Samples(cycle.extension_time(), j), Samples(cycle.rate_time(), j), Room(slopes, 0),
                    Room(slopes, 1));
    if (slopes.isZero(0)) continue;
    steep_.push_back(j);
    by_extension.push_back(slopes.col(0).mean());
    by_rate.push_back(slopes.col(1).mean());
  }
  const auto steep = static_cast<Eigen::Index>(steep_.size());
  const Eigen::MatrixXcd unit = Eigen::MatrixXcd::Identity(steep, steep);
  Eigen::VectorXcd slope(steep);
  slope.real() = Eigen::Map<const Eigen::VectorXd>(by_extension.data(), steep);
  for (Eigen::Index h = 0; h <= cycle.harmonics() && steep > 0; ++h) {
    slope.imag() = static_cast<double>(h) * cycle.omega() * Eigen::Map<const Eigen::VectorXd>(by_rate.data(), steep);
    Eigen::MatrixXcd effects(ports, steep);
    for (Eigen::Index k = 0; k < steep; ++k)
      effects.col(k) = slope[k] * cycle.receptance().row(h).segment(ports * steep_[static_cast<std::size_t>(k)], ports);
    const Eigen::MatrixXcd matrix = unit - effects(steep_, Eigen::all);
    answers_.push_back(effects.lazyProduct(Solved(matrix, unit)));
  }
}

Eigen::MatrixXcd MeanSlopeStep::Of(const Eigen::MatrixXcd& step) const {
  Eigen::MatrixXcd answer = step;
  for (std::size_t h = 0; h < answers_.size(); ++h) {
    const auto row = static_cast<Eigen::Index>(h);
    const Eigen::VectorXcd steep = step.row(row)(steep_);
    answer.row(row) += answers_[h].lazyProduct(steep).transpose();
  }
  return answer;
}

}  // namespace fourpost
