#include "vehicles/simulation/condensed_stepper.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "analysis/text/count_check.h"
#include "analysis/text/option_check.h"
#include "vehicles/condensed/linear_vehicle.h"

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// exp(matrix), then the integrals over u from 0 to 1 of exp((1 - u) matrix) input u^k / k! for k = 0 to 3, side by
/// side: the first rows of one exponential (Van Loan, IEEE Trans. Automatic Control 23, 1978).
MatrixXd ExponentialAndMoments(const MatrixXd& matrix, const MatrixXd& input) {
  const Index n = matrix.rows();
  const Index m = input.cols();
  MatrixXd chain = MatrixXd::Zero(n + 4 * m, n + 4 * m);
  chain.topLeftCorner(n, n) = matrix;
  chain.block(0, n, n, m) = input;
  for (Index k = 0; k < 3; ++k) chain.block(n + k * m, n + (k + 1) * m, m, m).setIdentity();
  return Exponential(chain).topRows(n);
}

/// Coefficients of u^k / k!, k = 0 to 3, of the cubic through [value slope] at u = 0 and at u = 1.
const Eigen::Matrix4d& Hermite() {
  static const Eigen::Matrix4d coefficients{{1, 0, 0, 0}, {0, 1, 0, 0}, {-6, -4, 6, -2}, {12, 6, -12, 6}};
  return coefficients;
}

/// From its first row and this column on; none where a model has no such.
void PutFrom(const MatrixXd& part, Index column, MatrixXd& whole) {
  whole.block(0, column, part.rows(), part.cols()) = part;
}

bool Sticks(const Port& port) { return std::holds_alternative<FrictionRemainder>(port.law); }

std::size_t Unsigned(Index count) { return static_cast<std::size_t>(count); }

/// Ports included in each step.
Index HeldOf(const std::vector<Port>& ports, CondensedStepper::Forces forces) {
  if (forces == CondensedStepper::Forces::kAdded) return std::ssize(ports);
  return std::count_if(ports.begin(), ports.end(), [](const Port& port) { return port.liftoff < 0; });
}

}  // namespace

CondensedStepper::CondensedStepper(const CondensedModel& model, double step_s, Forces forces)
    : CondensedStepper(model, step_s, forces, PortsOf(model)) {}

CondensedStepper::CondensedStepper(const CondensedModel& model, double step_s, Forces forces, std::vector<Port> ports)
    : step_s_(step_s),
      ports_(std::move(ports)),
      held_(HeldOf(ports_, forces)),
      acting_(held_),
      at_start_(ports_, step_s),
      at_end_(ports_, step_s) {
  RequireOption(step_s > 0 && std::isfinite(step_s), "CondensedStepper: step_s", step_s, "positive and finite");
  const LinearVehicle linear(model, LinearVehicle::Rates::kCentre);
  state_matrix_ = linear.StateMatrix();
  const Index posts = model.inputs();
  MatrixXd of_posts = MatrixXd::Zero(linear.size(), 2 * posts);
  PutFrom(model.post_stiffness, 0, of_posts);
  PutFrom(model.actuators, model.post_stiffness.cols(), of_posts);
  PutFrom(model.post_damping, posts, of_posts);
  by_posts_ = linear.StateInput(of_posts);
  MatrixXd tensions(linear.size(), static_cast<Index>(ports_.size()));
  for (std::size_t j = 0; j < ports_.size(); ++j) tensions.col(static_cast<Index>(j)) = -ports_[j].direction;
  on_remainder_ = linear.StateInput(tensions);
  post_.setZero(3 * posts);
  state_.setZero(state_matrix_.rows());
  free_ = state_;
  MakeStepMatrices();
  if (forces == Forces::kAdded) {
    on_added_ = linear.StateInput(MatrixXd::Identity(linear.size(), linear.size()));
    MakeForceMatrices();
  }
  MakePortRows(model);
  MakeTyreRows(model);
  MakeSensorRows(model);
  remainder_.setZero(on_remainder_.cols());
  trend_ = remainder_before_ = remainder_.head(held_);
  added_.setZero(on_added_.cols());
  extension_ = rate_ = remainder_;
  packed_.setZero(from_start_.cols());
}

void CondensedStepper::MakeStepMatrices() {
  const Index n = state_matrix_.rows();
  const Index posts = by_posts_.cols() / 2;
  const Index inputs = 2 * posts + held_;
  MatrixXd input(n, inputs);
  // In time u = t / h, where z' = dz/du / h.
  input << step_s_ * by_posts_.leftCols(posts), by_posts_.rightCols(posts), step_s_ * on_remainder_.leftCols(held_);
  const MatrixXd all = ExponentialAndMoments(step_s_ * state_matrix_, input);
  const auto moment = [&](Index k, Index first, Index count) { return all.block(0, n + k * inputs + first, n, count); };
  from_start_.resize(n, n + held_ + 4 * posts);
  from_start_.leftCols(n) = all.leftCols(n);
  from_end_ = moment(1, 2 * posts, held_);
  from_start_.middleCols(n, held_) = moment(0, 2 * posts, held_) - from_end_;
  for (Index place = 0; place < 4; ++place) {
    auto columns = from_start_.middleCols(n + held_ + place * posts, posts);
    columns.setZero();
    for (Index k = 0; k < 4; ++k) {
      columns += Hermite()(k, place) * moment(k, 0, posts);
      if (k > 0) columns += Hermite()(k, place) * moment(k - 1, posts, posts);
    }
    if (place % 2 == 1) columns *= step_s_;  // slopes in u are velocities times h
  }
}

void CondensedStepper::MakeForceMatrices() {
  const Index n = state_matrix_.rows();
  const Index size = on_added_.cols();
  const MatrixXd all = ExponentialAndMoments(step_s_ * state_matrix_, step_s_ * on_added_);
  added_from_end_ = all.middleCols(n + size, size);
  added_from_start_ = all.middleCols(n, size) - added_from_end_;
}

/// If they are not there yet.
void CondensedStepper::MakeLiftoffColumns() {
  if (from_liftoff_.size() > 0) return;
  const Index n = state_matrix_.rows();
  const Index liftoffs = on_remainder_.cols() - held_;
  const MatrixXd all = ExponentialAndMoments(step_s_ * state_matrix_, step_s_ * on_remainder_.rightCols(liftoffs));
  from_end_.conservativeResize(Eigen::NoChange, held_ + liftoffs);
  from_end_.rightCols(liftoffs) = all.middleCols(n + liftoffs, liftoffs);
  from_liftoff_ = all.middleCols(n, liftoffs) - from_end_.rightCols(liftoffs);
  at_end_.SetCompliance(extension_on_state_ * from_end_, rate_on_state_ * from_end_ + rate_on_remainder_);
}

// A rate of a massless coordinate x follows from the state and the remainders, not from the posts.
void CondensedStepper::MakePortRows(const CondensedModel& model) {
  const Index n = model.mass.rows();
  const Index series = state_matrix_.rows() - 2 * n;
  const auto count = static_cast<Index>(ports_.size());
  extension_on_state_.setZero(count, state_matrix_.rows());
  rate_on_state_.setZero(count, state_matrix_.rows());
  rate_on_remainder_.setZero(count, count);
  rate_on_added_.setZero(count, on_added_.cols());
  for (Index j = 0; j < count; ++j) {
    const Eigen::VectorXd& direction = ports_[static_cast<std::size_t>(j)].direction;
    extension_on_state_.row(j).head(n) = direction.head(n).transpose();
    extension_on_state_.row(j).tail(series) = direction.tail(series).transpose();
    if (const Index lag = ports_[static_cast<std::size_t>(j)].lag; lag >= 0) {
      // In place of its rate.
      rate_on_state_(j, n + lag) = 1;
      continue;
    }
    rate_on_state_.row(j) = direction.tail(series).transpose() * state_matrix_.bottomRows(series);
    rate_on_state_.row(j).segment(n, n) += direction.head(n).transpose();
    rate_on_remainder_.row(j) = direction.tail(series).transpose() * on_remainder_.bottomRows(series);
    if (on_added_.cols() > 0) rate_on_added_.row(j) = direction.tail(series).transpose() * on_added_.bottomRows(series);
  }
  at_start_.SetCompliance(MatrixXd::Zero(count, count), rate_on_remainder_);
  at_end_.SetCompliance(extension_on_state_.topRows(held_) * from_end_,
                        rate_on_state_.topRows(held_) * from_end_ + rate_on_remainder_.topLeftCorner(held_, held_));
}

// Of those that are not held. Tyres have no part in x: no remainder acts on their rates at once.
void CondensedStepper::MakeTyreRows(const CondensedModel& model) {
  const Index count = static_cast<Index>(ports_.size()) - held_;
  const Index posts = post_.size() / 3;
  compression_by_state_.resize(state_matrix_.rows(), count);
  compression_by_post_.setZero(2 * posts, count);
  preload_.resize(count);
  for (Index j = 0; j < count; ++j) {
    const auto place = static_cast<std::size_t>(ports_[static_cast<std::size_t>(held_ + j)].liftoff);
    const CondensedModel::Liftoff& tyre = model.liftoffs[place];
    compression_by_state_.col(j) = tyre.stiffness * extension_on_state_.row(held_ + j).transpose() +
                                   tyre.damping * rate_on_state_.row(held_ + j).transpose();
    preload_[j] = tyre.preload;
    if (tyre.post < 0) continue;
    compression_by_post_(tyre.post, j) = tyre.stiffness;
    compression_by_post_(posts + tyre.post, j) = tyre.damping;
  }
}

void CondensedStepper::MakeSensorRows(const CondensedModel& model) {
  const Index n = model.mass.rows();
  const Index sensors = model.on_position.rows();
  if (sensors == 0) {
    on_state_.resize(0, state_matrix_.rows());
    sensor_on_remainder_.resize(0, on_remainder_.cols());
    on_post_.resize(0, post_.size());
    return;
  }
  on_state_ = model.on_acceleration * state_matrix_.middleRows(n, n);
  on_state_.leftCols(n) += model.on_position;
  on_state_.middleCols(n, n) += model.on_velocity;
  on_post_.setZero(sensors, post_.size());
  const Index inputs = post_.size() / 3;
  PutFrom(model.on_post_height, 0, on_post_);
  PutFrom(model.on_post_velocity, inputs, on_post_);
  PutFrom(model.on_post_acceleration, 2 * inputs, on_post_);
  on_post_.leftCols(by_posts_.cols()) += model.on_acceleration * by_posts_.middleRows(n, n);
  sensor_on_remainder_ = model.on_acceleration * on_remainder_.middleRows(n, n);
  for (std::size_t j = 0; j < ports_.size(); ++j)
    for (const int cell : ports_[j].load_cells) sensor_on_remainder_(cell, static_cast<Index>(j)) += 1;
}

void CondensedStepper::SetPosts(std::span<const PostState> posts) {
  const auto count = static_cast<Index>(posts.size());
  for (Index p = 0; p < count; ++p) {
    const PostState& post = posts[static_cast<std::size_t>(p)];
    post_[p] = post.height;
    post_[count + p] = post.velocity;
    post_[2 * count + p] = post.acceleration;
  }
}

/// Of the first `count` ports, at the state as it is without their remainders.
bool CondensedStepper::SolvePorts(PortSolver& solver, Index count) {
  extension_.head(count).noalias() = extension_on_state_.topRows(count) * state_;
  rate_.head(count).noalias() = rate_on_state_.topRows(count) * state_;
  if (added_.size() > 0) rate_.head(count).noalias() += rate_on_added_.topRows(count) * added_;
  const Index posts = post_.size() / 3;
  for (Index j = 0; j < count; ++j) {
    const int post = ports_[static_cast<std::size_t>(j)].post;
    if (post < 0) continue;
    extension_[j] += post_[post];
    rate_[j] += post_[posts + post];
  }
  return solver.Solve(count, extension_, rate_, remainder_);
}

/// At the state as it is, were all of them linear.
bool CondensedStepper::AnyTyrePulls() const {
  for (Index j = 0; j < preload_.size(); ++j) {
    const double compression = preload_[j] + compression_by_state_.col(j).dot(state_) +
                               compression_by_post_.col(j).dot(post_.head(compression_by_post_.rows()));
    if (compression < 0) return true;
  }
  return false;
}

void CondensedStepper::Start(std::span<const PostState> posts) {
  RequireCount("CondensedStepper", "posts", post_count(), posts.size());
  SetPosts(posts);
  state_.setZero();
  remainder_.setZero();
  added_.setZero();
  unsolved_steps_ = 0;
  at_start_.Rest();
  at_end_.Rest();
  FinishStart();
}

void CondensedStepper::SetState(const Eigen::VectorXd& state, std::span<const PostState> posts) {
  const Index strokes = state.size() - state_.size();
  const Index frictions = std::count_if(ports_.begin(), ports_.end(), Sticks);
  if (strokes != 0)
    RequireCount("CondensedStepper", "states and strokes", Unsigned(state_.size() + frictions), Unsigned(state.size()));
  SetPosts(posts);
  state_ = state.head(state_.size());
  added_.setZero();
  at_start_.Rest();
  at_end_.Rest();
  if (strokes > 0) RestFrictions(state.tail(strokes));
  FinishStart();
}

/// Where their strokes [m] began that lead to the state as it is.
void CondensedStepper::RestFrictions(const Eigen::VectorXd& strokes) {
  Index next = 0;
  for (std::size_t j = 0; j < ports_.size(); ++j)
    if (Sticks(ports_[j])) {
      const auto port = static_cast<Index>(j);
      at_start_.RestFriction(port, extension_on_state_.row(port).dot(state_) - strokes[next++]);
    }
}

/// Which ports act at a state follows from it.
void CondensedStepper::FinishStart() {
  const Index ports = remainder_.size();
  acting_ = AnyTyrePulls() ? ports : held_;
  trend_.setZero();
  if (acting_ == 0) remainder_.setZero();
  else if (SolvePorts(at_start_, acting_)) {
    at_start_.Advance();
    at_end_.RememberFriction(at_start_.memory());
  } else {
    ++unsolved_steps_;
  }
}

void CondensedStepper::Step(std::span<const PostState> posts) {
  AdvanceState(posts);
  if (remainder_.size() > 0) FinishStep();
}

void CondensedStepper::Step(std::span<const PostState> posts, const Eigen::VectorXd& added) {
  RequireCount("CondensedStepper", "added forces", static_cast<std::size_t>(on_added_.cols()),
               static_cast<std::size_t>(added.size()));
  AdvanceState(posts);
  state_.noalias() += added_from_start_ * added_;
  state_.noalias() += added_from_end_ * added;
  added_ = added;
  if (remainder_.size() > 0) FinishStep();
}

/// But for the remainders at the end, and for added forces.
void CondensedStepper::AdvanceState(std::span<const PostState> posts) {
  const Index n = state_.size();
  const Index half = 2 * (post_.size() / 3);
  packed_.head(n) = state_;
  packed_.segment(n, held_) = remainder_.head(held_);
  packed_.segment(n + held_, half) = post_.head(half);
  SetPosts(posts);
  packed_.tail(half) = post_.head(half);
  state_.noalias() = from_start_ * packed_;
}

void CondensedStepper::FinishStep() {
  const Index ports = remainder_.size();
  const bool lifted = lifts();
  if (lifted) {
    MakeLiftoffColumns();
    state_.noalias() += from_liftoff_ * remainder_.tail(ports - held_);
  }
  free_ = state_;
  remainder_before_ = remainder_.head(held_);
  remainder_.head(held_) += trend_;
  bool solved = true;
  if (!lifted && held_ > 0) {
    solved = SolvePorts(at_end_, held_);
    state_.noalias() += from_end_.leftCols(held_) * remainder_.head(held_);
  }
  if (lifted || AnyTyrePulls()) {
    MakeLiftoffColumns();
    state_ = free_;
    solved = SolvePorts(at_end_, ports);
    state_.noalias() += from_end_ * remainder_;
    acting_ = remainder_.tail(ports - held_).isZero(0) ? held_ : ports;
  }
  trend_ = remainder_.head(held_) - remainder_before_;
  if (solved) at_end_.Advance();
  else ++unsolved_steps_;
}

void CondensedStepper::Store(Moment& moment) const {
  moment.state = state_;
  moment.remainder = remainder_;
  moment.trend = trend_;
  moment.post = post_;
  moment.added = added_;
  moment.memory = at_end_.memory();
  moment.acting = acting_;
  moment.unsolved_steps = unsolved_steps_;
}

void CondensedStepper::Return(const Moment& moment) {
  state_ = moment.state;
  remainder_ = moment.remainder;
  trend_ = moment.trend;
  post_ = moment.post;
  added_ = moment.added;
  at_end_.Remember(moment.memory);
  acting_ = moment.acting;
  unsolved_steps_ = moment.unsolved_steps;
}

Eigen::VectorXd CondensedStepper::StateRate() const {
  Eigen::VectorXd rate = state_matrix_ * state_;
  rate.noalias() += by_posts_ * post_.head(by_posts_.cols());
  rate.noalias() += on_remainder_ * remainder_;
  if (added_.size() > 0) rate.noalias() += on_added_ * added_;
  return rate;
}

void CondensedStepper::Read(Eigen::Ref<Eigen::VectorXd> readings) const {
  readings.noalias() = on_state_ * state_;
  readings.noalias() += sensor_on_remainder_.leftCols(acting_) * remainder_.head(acting_);
  readings.noalias() += on_post_ * post_;
}

}  // namespace fourpost
