#include "vehicles/condensed/model_change.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {
namespace {

/// Of the larger of a value and a hundredth of its range: rounding and curvature each leave some 1e-8 to 1e-6.
constexpr double kStep = 1e-6;

Eigen::MatrixXd Difference(const Eigen::MatrixXd& changed, const Eigen::MatrixXd& from, double step) {
  if (changed == from) return {};
  return (changed - from) / step;
}

bool AreOfOneElement(const Port& a, const Port& b) {
  return a.law.index() == b.law.index() && a.direction == b.direction && a.post == b.post && a.liftoff == b.liftoff;
}

}  // namespace

ModelChanges::ModelChanges(const CondensedVehicle& vehicle, std::span<const double> values)
    : vehicle_(vehicle),
      values_(values.begin(), values.end()),
      model_(vehicle.At(values)),
      linear_(model_, LinearVehicle::Rates::kCentre),
      ports_(PortsOf(model_)) {}

double DifferenceOf(const Parameter& parameter, double value) {
  const double scale = std::max(std::abs(value), 0.01 * (parameter.upper - parameter.lower));
  return kStep * (scale > 0 ? scale : 1);
}

ModelChange ModelChanges::By(std::size_t parameter) const {
  if (parameter >= values_.size()) throw std::invalid_argument("ModelChanges: no parameter of this index");
  std::vector<double> values = values_;
  values[parameter] += DifferenceOf(vehicle_.vehicle().parameters[parameter], values[parameter]);
  const double step = values[parameter] - values_[parameter];
  const CondensedModel model = vehicle_.At(values);
  const LinearVehicle linear(model, LinearVehicle::Rates::kCentre);
  if (linear.size() != linear_.size())
    throw std::invalid_argument("ModelChanges: a damper gains a series spring with the parameter '" +
                                vehicle_.vehicle().parameters[parameter].name + "'");
  return To(model, linear, step);
}

std::optional<ModelChange> ModelChanges::To(const CondensedModel& other) const {
  if (other.mass.rows() != model_.mass.rows() || other.inputs() != model_.inputs() ||
      other.post_stiffness.cols() != model_.post_stiffness.cols() ||
      other.on_position.rows() != model_.on_position.rows())
    return std::nullopt;
  const LinearVehicle linear(other, LinearVehicle::Rates::kCentre);
  if (linear.size() != linear_.size()) return std::nullopt;
  return To(other, linear, 1);
}

ModelChange ModelChanges::To(const CondensedModel& model, const LinearVehicle& linear, double step) const {
  return {.mass = Difference(linear.mass, linear_.mass, step),
          .damping = Difference(linear.damping, linear_.damping, step),
          .stiffness = Difference(linear.stiffness, linear_.stiffness, step),
          .post_stiffness = Difference(model.post_stiffness, model_.post_stiffness, step),
          .post_damping = Difference(model.post_damping, model_.post_damping, step),
          .on_position = Difference(model.on_position, model_.on_position, step),
          .on_velocity = Difference(model.on_velocity, model_.on_velocity, step),
          .on_acceleration = Difference(model.on_acceleration, model_.on_acceleration, step),
          .on_post_height = Difference(model.on_post_height, model_.on_post_height, step),
          .on_post_velocity = Difference(model.on_post_velocity, model_.on_post_velocity, step),
          .on_post_acceleration = Difference(model.on_post_acceleration, model_.on_post_acceleration, step),
          .laws = ChangedLaws(PortsOf(model)),
          .step = step};
}

/// Elements that are linear have no port, and may gain or lose it. Which of several with one direction counts as which
/// does not matter: only the sum of their forces does.
std::vector<ModelChange::Law> ModelChanges::ChangedLaws(const std::vector<Port>& changed) const {
  std::vector<ModelChange::Law> laws;
  std::vector<bool> is_taken(ports_.size(), false);
  for (const Port& port : changed) {
    std::size_t i = 0;
    while (i < ports_.size() && (is_taken[i] || !AreOfOneElement(ports_[i], port))) ++i;
    if (i == ports_.size()) {
      laws.push_back({-1, port});
      continue;
    }
    is_taken[i] = true;
    if (!(ports_[i].law == port.law)) laws.push_back({static_cast<int>(i), port});
  }
  for (std::size_t i = 0; i < ports_.size(); ++i)
    if (!is_taken[i]) laws.push_back({static_cast<int>(i), {}});
  return laws;
}

}  // namespace fourpost
