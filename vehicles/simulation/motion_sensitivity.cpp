#include "vehicles/simulation/motion_sensitivity.h"

#include <algorithm>
#include <variant>

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

bool IsSameElement(const Port& a, const Port& b) {
  return a.law.index() == b.law.index() && !std::holds_alternative<HydraulicRemainder>(a.law) && a.post == b.post &&
         a.liftoff == b.liftoff && a.direction.size() == b.direction.size();
}

}  // namespace

bool MotionSensitivity::Covers(const CondensedModel& model, const CondensedModel& neighbour) {
  if (model.mass.rows() != neighbour.mass.rows()) return false;
  const std::vector<Port> ports = PortsOf(model);
  const std::vector<Port> others = PortsOf(neighbour);
  return std::equal(ports.begin(), ports.end(), others.begin(), others.end(), IsSameElement);
}

MotionSensitivity::MotionSensitivity(const CondensedModel& model, std::span<const CondensedModel> neighbours,
                                     double step_s) {
  const CondensedStepper base(model, step_s);
  neighbours_.reserve(neighbours.size());
  for (const CondensedModel& neighbour : neighbours) {
    const CondensedStepper& other = neighbours_.emplace_back(neighbour, step_s);
    for (std::size_t j = 0; j < base.ports_.size(); ++j)
      if (!(other.ports_[j].law == base.ports_[j].law))
        laws_.push_back({static_cast<Index>(j), count() - 1, other.ports_[j].law});
  }
  from_start_ = Stacked(base, &CondensedStepper::from_start_);
  from_end_ = Stacked(base, &CondensedStepper::from_end_);
  extension_on_state_ = Stacked(base, &CondensedStepper::extension_on_state_);
  rate_on_state_ = Stacked(base, &CondensedStepper::rate_on_state_);
  rate_on_remainder_ = Stacked(base, &CondensedStepper::rate_on_remainder_);
  on_state_ = Stacked(base, &CondensedStepper::on_state_);
  sensor_on_remainder_ = Stacked(base, &CondensedStepper::sensor_on_remainder_);
  on_post_ = Stacked(base, &CondensedStepper::on_post_);
  state_.setZero(base.state_.size(), count());
  remainder_.setZero(base.remainder_.size(), count());
  free_ = state_;
  extension_ = rate_ = remainder_;
}

MatrixXd MotionSensitivity::Stacked(const CondensedStepper& base, MatrixXd CondensedStepper::*part) const {
  const MatrixXd& own = base.*part;
  MatrixXd stack(count() * own.rows(), own.cols());
  for (Index i = 0; i < count(); ++i)
    stack.middleRows(i * own.rows(), own.rows()) = neighbours_[static_cast<std::size_t>(i)].*part - own;
  return stack.isZero(0) ? MatrixXd() : stack;
}

void MotionSensitivity::Add(const MatrixXd& stack, const Eigen::Ref<const Eigen::VectorXd>& vector,
                            Eigen::Ref<MatrixXd> sum) {
  if (stack.size() == 0) return;
  product_.noalias() = stack.leftCols(vector.size()) * vector;
  const Index rows = stack.rows() / count();
  // The first rows may be wanted alone.
  for (Index i = 0; i < count(); ++i) sum.col(i) += product_.segment(i * rows, sum.rows());
}

void MotionSensitivity::MakeLiftoffColumns(const CondensedStepper& base) {
  if (neighbours_.empty() || neighbours_.front().from_liftoff_.size() > 0) return;
  for (CondensedStepper& neighbour : neighbours_) neighbour.MakeLiftoffColumns();
  from_end_ = Stacked(base, &CondensedStepper::from_end_);
  from_liftoff_ = Stacked(base, &CondensedStepper::from_liftoff_);
}

void MotionSensitivity::SolvePorts(const CondensedStepper& base, const PortSolver& solver, Index ports,
                                   const MatrixXd& state) {
  auto extension = extension_.topRows(ports);
  auto rate = rate_.topRows(ports);
  extension.noalias() = base.extension_on_state_.topRows(ports) * state;
  rate.noalias() = base.rate_on_state_.topRows(ports) * state;
  Add(extension_on_state_, base.state_, extension);
  Add(rate_on_state_, base.state_, rate);
  Add(rate_on_remainder_, base.remainder_, rate);
  remainder_.setZero();
  for (const Law& law : laws_)
    if (law.port < ports) remainder_(law.port, law.neighbour) = solver.Departure(law.port, law.law);
  solver.Change(extension, rate, remainder_.topRows(ports));
}

void MotionSensitivity::Start(const CondensedStepper& base) {
  state_.setZero();
  remainder_.setZero();
  remainder_before_ = base.remainder_;
  lifted_before_ = base.lifts();
  if (base.acting_ > 0) SolvePorts(base, base.at_start_, base.acting_, state_);
}

void MotionSensitivity::Step(const CondensedStepper& base) {
  const Index n = state_.rows();
  const Index held = base.held_;
  const bool lifts = lifted_before_ || base.lifts();
  if (lifts) MakeLiftoffColumns(base);
  const Index ports = lifts ? remainder_.rows() : held;
  free_.noalias() = base.from_start_.leftCols(n) * state_;
  free_.noalias() += base.from_start_.middleCols(n, held) * remainder_.topRows(held);
  Add(from_start_, base.packed_, free_);
  if (lifts) {
    const Index tyres = remainder_.rows() - held;
    free_.noalias() += base.from_liftoff_ * remainder_.bottomRows(tyres);
    Add(from_liftoff_, remainder_before_.tail(tyres), free_);
  }
  Add(from_end_, base.remainder_.head(ports), free_);
  if (ports > 0) SolvePorts(base, base.at_end_, ports, free_);
  state_ = free_;
  state_.noalias() += base.from_end_.leftCols(ports) * remainder_.topRows(ports);
  remainder_before_ = base.remainder_;
  lifted_before_ = base.lifts();
}

void MotionSensitivity::Read(const CondensedStepper& base, Eigen::Ref<MatrixXd> changes) {
  changes.noalias() = base.on_state_ * state_;
  changes.noalias() += base.sensor_on_remainder_ * remainder_;
  Add(on_state_, base.state_, changes);
  Add(sensor_on_remainder_, base.remainder_, changes);
  Add(on_post_, base.post_, changes);
}

}  // namespace fourpost
