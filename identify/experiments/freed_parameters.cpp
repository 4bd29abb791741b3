#include "identify/experiments/freed_parameters.h"

namespace fourpost {

FreedParameters::FreedParameters(const ParameterSpread& spread, const Vehicle& vehicle)
    : values_(vehicle.ParameterValues()), count_(spread.lattice.size()) {
  for (const LatticeAxis& axis : spread.lattice.axes())
    for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
      if (vehicle.parameters[i].name == axis.name) places_.push_back(i);
}

std::vector<double> FreedParameters::AllWith(const Eigen::VectorXd& free) const {
  std::vector<double> all = values_;
  for (std::size_t i = 0; i < places_.size(); ++i) all[places_[i]] = free[static_cast<Eigen::Index>(i)];
  return all;
}

}  // namespace fourpost
