#include "vehicles/simulation/motion_sensitivity.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

bool IsHydraulic(const Port& port) { return std::holds_alternative<HydraulicRemainder>(port.law); }
bool IsFriction(const Port& port) { return std::holds_alternative<FrictionRemainder>(port.law); }

/// Within `share` of its direction.
bool IsSameElement(const Port& a, const Port& b, double share) {
  return a.law.index() == b.law.index() && a.post == b.post && (a.liftoff < 0) == (b.liftoff < 0) &&
         (a.direction - b.direction).norm() <= share * a.direction.norm();
}

/// Which of a neighbour's ports is which of the model's.
struct Match {
  /// Of each of the model's, -1: none.
  std::vector<int> of_model;
  /// Those of the neighbour that the model has not.
  std::vector<int> added;
};

/// Those of one direction first, then those that a parameter has turned a little.
Match Matched(const std::vector<Port>& ports, const std::vector<Port>& others) {
  Match match{std::vector<int>(ports.size(), -1), {}};
  std::vector<bool> is_taken(others.size(), false);
  for (const double share : {1e-9, 1e-3})
    for (std::size_t j = 0; j < ports.size(); ++j) {
      if (match.of_model[j] >= 0) continue;
      for (std::size_t i = 0; i < others.size() && match.of_model[j] < 0; ++i)
        if (!is_taken[i] && IsSameElement(ports[j], others[i], share)) match.of_model[j] = static_cast<int>(i);
      if (match.of_model[j] >= 0) is_taken[static_cast<std::size_t>(match.of_model[j])] = true;
    }
  for (std::size_t i = 0; i < others.size(); ++i)
    if (!is_taken[i]) match.added.push_back(static_cast<int>(i));
  return match;
}

/// The neighbour's, each in the place of the model's; where it has none, the model's own, whose force it leaves out.
std::vector<Port> InPlace(const std::vector<Port>& ports, const std::vector<Port>& others, const Match& match) {
  std::vector<Port> aligned = ports;
  for (std::size_t j = 0; j < ports.size(); ++j)
    if (match.of_model[j] >= 0) aligned[j] = others[static_cast<std::size_t>(match.of_model[j])];
  return aligned;
}

/// Its force would need a memory of its own.
bool IsFrictionAdded(const std::vector<Port>& others, const Match& match) {
  return std::any_of(match.added.begin(), match.added.end(),
                     [&](int i) { return IsFriction(others[static_cast<std::size_t>(i)]); });
}

bool IsLiftoffLost(const std::vector<Port>& ports, const Match& match) {
  for (std::size_t j = 0; j < ports.size(); ++j)
    if (ports[j].liftoff >= 0 && match.of_model[j] < 0) return true;
  return false;
}

}  // namespace

bool MotionSensitivity::Covers(const CondensedModel& model, const CondensedModel& neighbour) {
  if (model.mass.rows() != neighbour.mass.rows() || model.inputs() != neighbour.inputs() ||
      model.on_position.rows() != neighbour.on_position.rows() ||
      model.SeriesDampers().size() != neighbour.SeriesDampers().size())
    return false;
  const std::vector<Port> ports = PortsOf(model);
  const std::vector<Port> others = PortsOf(neighbour);
  const Match match = Matched(ports, others);
  return std::none_of(ports.begin(), ports.end(), IsHydraulic) &&
         std::none_of(others.begin(), others.end(), IsHydraulic) && !IsLiftoffLost(ports, match) &&
         !IsFrictionAdded(others, match);
}

MotionSensitivity::MotionSensitivity(const CondensedModel& model, std::span<const CondensedModel> neighbours,
                                     double step_s) {
  const CondensedStepper base(model, step_s);
  neighbours_.reserve(neighbours.size());
  for (const CondensedModel& neighbour : neighbours) {
    const std::vector<Port> ports = PortsOf(neighbour);
    const Match match = Matched(base.ports_, ports);
    neighbours_.push_back(
        CondensedStepper(neighbour, step_s, CondensedStepper::Forces::kNone, InPlace(base.ports_, ports, match)));
    for (std::size_t j = 0; j < base.ports_.size(); ++j) {
      const int other = match.of_model[j];
      if (other < 0) laws_.push_back({static_cast<Index>(j), count() - 1, {}});
      else if (const PortLaw& law = ports[static_cast<std::size_t>(other)].law; !(law == base.ports_[j].law))
        laws_.push_back({static_cast<Index>(j), count() - 1, law});
    }
    for (const int i : match.added) added_.push_back({count() - 1, ports[static_cast<std::size_t>(i)]});
  }
  from_start_ = Stacked(base, &CondensedStepper::from_start_);
  from_end_ = Stacked(base, &CondensedStepper::from_end_);
  extension_on_state_ = Stacked(base, &CondensedStepper::extension_on_state_);
  rate_on_state_ = Stacked(base, &CondensedStepper::rate_on_state_);
  rate_on_remainder_ = Stacked(base, &CondensedStepper::rate_on_remainder_);
  on_state_ = Stacked(base, &CondensedStepper::on_state_);
  sensor_on_remainder_ = Stacked(base, &CondensedStepper::sensor_on_remainder_);
  on_post_ = Stacked(base, &CondensedStepper::on_post_);
  MakeAddedPorts(base, model);
  state_.setZero(base.state_.size(), count());
  remainder_.setZero(base.remainder_.size(), count());
  free_ = state_;
  extension_ = rate_ = remainder_;
  for (std::size_t j = 0; j < base.ports_.size(); ++j)
    if (IsFriction(base.ports_[j])) frictions_.push_back(static_cast<Index>(j));
  friction_extension_.setZero(std::ssize(frictions_), count());
  friction_force_ = friction_extension_;
}

/// What the friction of the next step starts from.
void MotionSensitivity::NoteFrictions(const CondensedStepper& base) {
  if (frictions_.empty()) return;
  extension_.noalias() = base.extension_on_state_ * state_;
  Add(extension_on_state_, base.state_, extension_);
  friction_extension_ = extension_(frictions_, Eigen::all);
  friction_force_ = remainder_(frictions_, Eigen::all);
}

/// To first order their forces act on the model as it is: on one that has them all.
void MotionSensitivity::MakeAddedPorts(const CondensedStepper& base, const CondensedModel& model) {
  const Index added = std::ssize(added_);
  added_before_ = added_forces_ = Eigen::VectorXd::Zero(added);
  rate_on_added_.resize(base.remainder_.size(), added);
  if (added == 0) return;
  std::vector<Port> ports = base.ports_;
  std::vector<Port> forces;
  for (const AddedPort& one : added_) {
    forces.push_back(one.port);
    forces.back().liftoff = -1;
  }
  ports.insert(ports.begin() + base.held_, forces.begin(), forces.end());
  const CondensedStepper with(model, base.step_s_, CondensedStepper::Forces::kNone, std::move(ports));
  const Index n = base.state_.size();
  const Index held = base.held_;
  added_from_start_ = with.from_start_.middleCols(n + held, added);
  added_from_end_ = with.from_end_.middleCols(held, added);
  added_extension_on_state_ = with.extension_on_state_.middleRows(held, added);
  added_rate_on_state_ = with.rate_on_state_.middleRows(held, added);
  const auto own = [&](Index j) { return j < held ? j : j + added; };
  std::vector<Index> places(static_cast<std::size_t>(base.remainder_.size()));
  for (Index j = 0; j < base.remainder_.size(); ++j) places[static_cast<std::size_t>(j)] = own(j);
  rate_on_added_ = with.rate_on_remainder_(places, Eigen::seqN(held, added));
  added_rate_on_remainder_ = with.rate_on_remainder_(Eigen::seqN(held, added), places);
  sensor_on_added_ = with.sensor_on_remainder_.middleCols(held, added);
}

/// As the motion of the model gives them.
void MotionSensitivity::FindAddedForces(const CondensedStepper& base) {
  const Index posts = base.post_.size() / 3;
  for (Index k = 0; k < added_forces_.size(); ++k) {
    const Port& port = added_[static_cast<std::size_t>(k)].port;
    double extension = added_extension_on_state_.row(k).dot(base.state_);
    double rate = added_rate_on_state_.row(k).dot(base.state_) + added_rate_on_remainder_.row(k).dot(base.remainder_);
    if (port.post >= 0) {
      extension += base.post_[port.post];
      rate += base.post_[posts + port.post];
    }
    Remainders(port.law, {&extension, 1}, {&rate, 1}, {added_forces_.data() + k, 1});
  }
}

void MotionSensitivity::AddForces(const Eigen::Ref<const MatrixXd>& columns, const Eigen::VectorXd& forces,
                                  Eigen::Ref<MatrixXd> sum) const {
  for (Index k = 0; k < forces.size(); ++k)
    sum.col(added_[static_cast<std::size_t>(k)].neighbour) += forces[k] * columns.col(k);
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
  AddForces(rate_on_added_.topRows(ports), added_forces_, rate);
  remainder_.setZero();
  for (const Law& law : laws_)
    if (law.port < ports)
      remainder_(law.port, law.neighbour) = law.law ? solver.Departure(law.port, *law.law) : -base.remainder_[law.port];
  for (std::size_t k = 0; k < frictions_.size(); ++k) {
    const auto row = static_cast<Index>(k);
    const auto [by_extension, by_force] = solver.ByStart(frictions_[k]);
    remainder_.row(frictions_[k]) += by_extension * friction_extension_.row(row) + by_force * friction_force_.row(row);
  }
  solver.Change(extension, rate, remainder_.topRows(ports));
}

void MotionSensitivity::Start(const CondensedStepper& base) {
  state_.setZero();
  remainder_.setZero();
  remainder_before_ = base.remainder_;
  lifted_before_ = base.lifts();
  FindAddedForces(base);
  added_before_ = added_forces_;
  friction_extension_.setZero();
  friction_force_.setZero();
  if (base.acting_ > 0) SolvePorts(base, base.at_start_, base.acting_, state_);
  NoteFrictions(base);
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
  FindAddedForces(base);
  AddForces(added_from_start_, added_before_, free_);
  AddForces(added_from_end_, added_forces_, free_);
  if (ports > 0) SolvePorts(base, base.at_end_, ports, free_);
  state_ = free_;
  state_.noalias() += base.from_end_.leftCols(ports) * remainder_.topRows(ports);
  NoteFrictions(base);
  remainder_before_ = base.remainder_;
  added_before_ = added_forces_;
  lifted_before_ = base.lifts();
}

void MotionSensitivity::Read(const CondensedStepper& base, Eigen::Ref<MatrixXd> changes) {
  changes.noalias() = base.on_state_ * state_;
  changes.noalias() += base.sensor_on_remainder_ * remainder_;
  AddForces(sensor_on_added_, added_forces_, changes);
  Add(on_state_, base.state_, changes);
  Add(sensor_on_remainder_, base.remainder_, changes);
  Add(on_post_, base.post_, changes);
}

}  // namespace fourpost
