#include "vehicles/condensed/lacking_forces.h"

#include <algorithm>
#include <variant>

#include "analysis/text/count_check.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of [s x]; without the springs that stand for hydraulic dampers.
std::vector<Index> SeriesOf(const std::vector<Port>& ports, Index n, Index size) {
  std::vector<Index> series;
  for (Index x = n; x < size; ++x)
    if (std::none_of(ports.begin(), ports.end(), [x](const Port& port) { return port.lag == x; })) series.push_back(x);
  return series;
}

Eigen::MatrixXd SeriesDirections(const CondensedModel& model, const std::vector<Index>& series) {
  const std::vector<const CondensedModel::Dashpot*> dampers = model.SeriesDampers();
  const Index n = model.mass.rows();
  Eigen::MatrixXd directions(n, static_cast<Index>(series.size()));
  for (std::size_t j = 0; j < series.size(); ++j)
    directions.col(static_cast<Index>(j)) = dampers[static_cast<std::size_t>(series[j] - n)]->direction;
  return directions;
}

}  // namespace

LackingForces::LackingForces(Multibody& multibody, const CondensedModel& model)
    : multibody_(multibody), chart_(multibody) {
  const std::vector<Port> ports = PortsOf(model);
  for (std::size_t j = 0; j < ports.size(); ++j) {
    if (std::holds_alternative<HydraulicRemainder>(ports[j].law)) hydraulics_.push_back(j);
    if (std::holds_alternative<FrictionRemainder>(ports[j].law)) frictions_.push_back(j);
  }
  size_ = model.mass.rows() + static_cast<Index>(model.SeriesDampers().size());
  RequireCount("LackingForces: model", "coordinates", static_cast<std::size_t>(chart_.size()),
               static_cast<std::size_t>(model.mass.rows()));
  series_ = SeriesOf(ports, chart_.size(), size_);
  series_directions_ = SeriesDirections(model, series_);
  RequireCount("LackingForces: model", "states of dampers",
               static_cast<std::size_t>(multibody.state_size() - 2 * multibody.coordinate_count()),
               series_.size() + 2 * hydraulics_.size() + frictions_.size());
}

/// z of the multibody system.
Eigen::VectorXd LackingForces::States(const Eigen::VectorXd& of_series, const Eigen::VectorXd& of_memory) const {
  Eigen::VectorXd states(static_cast<Index>(series_.size()) + of_memory.size());
  for (std::size_t j = 0; j < series_.size(); ++j) states[static_cast<Index>(j)] = of_series[series_[j]];
  states.tail(of_memory.size()) = of_memory;
  return states;
}

/// A series damper pulls on s with its spring in the multibody system, with its dashpot in the linear vehicle; what the
/// two differ by is lacking on x. What stands for a hydraulic damper on x is linear in both, and lacks nothing.
Eigen::VectorXd LackingForces::At(double t, const Motion& motion) {
  const Index n = chart_.size();
  const Chart::Motion now = chart_.Follow(t, motion.position.head(n), motion.rate.head(n), motion.acceleration,
                                          States(motion.position, motion.memory));
  // Rates of the memory follow from those, and move nothing.
  derivative_.resize(multibody_.state_size());
  derivative_ << now.rate, now.acceleration, States(motion.rate, Eigen::VectorXd::Zero(motion.memory.size()));
  const Eigen::VectorXd residual = multibody_.Residual(derivative_);
  const Eigen::VectorXd missing = residual.segment(now.q.size(), series_directions_.cols());
  Eigen::VectorXd lacking = Eigen::VectorXd::Zero(size_);
  lacking.head(n) = now.tangent.transpose() * residual.head(now.q.size()) - series_directions_ * missing;
  for (std::size_t j = 0; j < series_.size(); ++j) lacking[series_[j]] = missing[static_cast<Index>(j)];
  return lacking;
}

Eigen::VectorXd LackingForces::MemoryExtensions(const Eigen::VectorXd& position) {
  chart_.MoveTo(position.head(chart_.size()));
  return multibody_.MemoryExtensions();
}

}  // namespace fourpost
