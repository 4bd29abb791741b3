#include "vehicles/simulation/condensed_stepper.h"

#include <cmath>

#include <unsupported/Eigen/MatrixFunctions>

#include "analysis/option_check.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/laws/count_check.h"

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
  return chain.exp().topRows(n);
}

/// Coefficients of u^k / k!, k = 0 to 3, of the cubic through [value slope] at u = 0 and at u = 1.
const Eigen::Matrix4d& Hermite() {
  static const Eigen::Matrix4d coefficients{{1, 0, 0, 0}, {0, 1, 0, 0}, {-6, -4, 6, -2}, {12, 6, -12, 6}};
  return coefficients;
}

}  // namespace

CondensedStepper::CondensedStepper(const CondensedModel& model, double step_s)
    : step_s_(step_s), ports_(PortsOf(model)), at_start_(ports_, step_s), at_end_(ports_, step_s) {
  RequireOption(step_s > 0 && std::isfinite(step_s), "CondensedStepper: step_s", step_s, "positive and finite");
  const LinearVehicle linear(model, LinearVehicle::Rates::kCentre);
  const MatrixXd state_matrix = linear.StateMatrix();
  const Index n = model.mass.rows();
  const Index posts = model.post_stiffness.cols();
  MatrixXd forces = MatrixXd::Zero(linear.size(), 2 * posts);
  forces.topRows(n) << model.post_stiffness, model.post_damping;
  const MatrixXd by_posts = linear.StateInput(forces);
  MatrixXd tensions(linear.size(), static_cast<Index>(ports_.size()));
  for (std::size_t j = 0; j < ports_.size(); ++j) tensions.col(static_cast<Index>(j)) = -ports_[j].direction;
  on_remainder_ = linear.StateInput(tensions);
  post_.setZero(3 * posts);
  state_.setZero(state_matrix.rows());
  MakeStepMatrices(state_matrix, by_posts);
  MakePortRows(model, state_matrix);
  MakeSensorRows(model, state_matrix, by_posts);
  remainder_.setZero(on_remainder_.cols());
  extension_ = rate_ = remainder_;
  packed_.setZero(from_start_.cols());
}

void CondensedStepper::MakeStepMatrices(const MatrixXd& state_matrix, const MatrixXd& by_posts) {
  const Index n = state_matrix.rows();
  const Index posts = by_posts.cols() / 2;
  const Index ports = on_remainder_.cols();
  const Index inputs = 2 * posts + ports;
  MatrixXd input(n, inputs);
  // In time u = t / h, where z' = dz/du / h.
  input << step_s_ * by_posts.leftCols(posts), by_posts.rightCols(posts), step_s_ * on_remainder_;
  const MatrixXd all = ExponentialAndMoments(step_s_ * state_matrix, input);
  const auto moment = [&](Index k, Index first, Index count) { return all.block(0, n + k * inputs + first, n, count); };
  from_start_.resize(n, n + ports + 4 * posts);
  from_start_.leftCols(n) = all.leftCols(n);
  from_end_ = moment(1, 2 * posts, ports);
  from_start_.middleCols(n, ports) = moment(0, 2 * posts, ports) - from_end_;
  for (Index place = 0; place < 4; ++place) {
    auto columns = from_start_.middleCols(n + ports + place * posts, posts);
    columns.setZero();
    for (Index k = 0; k < 4; ++k) {
      columns += Hermite()(k, place) * moment(k, 0, posts);
      if (k > 0) columns += Hermite()(k, place) * moment(k - 1, posts, posts);
    }
    if (place % 2 == 1) columns *= step_s_;  // slopes in u are velocities times h
  }
}

// A rate of a massless coordinate x follows from the state and the remainders, not from the posts.
void CondensedStepper::MakePortRows(const CondensedModel& model, const MatrixXd& state_matrix) {
  const Index n = model.mass.rows();
  const Index series = state_matrix.rows() - 2 * n;
  const auto count = static_cast<Index>(ports_.size());
  extension_on_state_.setZero(count, state_matrix.rows());
  rate_on_state_.setZero(count, state_matrix.rows());
  rate_on_remainder_.setZero(count, count);
  for (Index j = 0; j < count; ++j) {
    const Eigen::VectorXd& direction = ports_[static_cast<std::size_t>(j)].direction;
    extension_on_state_.row(j).head(n) = direction.head(n).transpose();
    extension_on_state_.row(j).tail(series) = direction.tail(series).transpose();
    if (const Index lag = ports_[static_cast<std::size_t>(j)].lag; lag >= 0) {
      // In place of its rate.
      rate_on_state_(j, n + lag) = 1;
      continue;
    }
    rate_on_state_.row(j) = direction.tail(series).transpose() * state_matrix.bottomRows(series);
    rate_on_state_.row(j).segment(n, n) += direction.head(n).transpose();
    rate_on_remainder_.row(j) = direction.tail(series).transpose() * on_remainder_.bottomRows(series);
  }
  at_start_.SetCompliance(MatrixXd::Zero(count, count), rate_on_remainder_);
  at_end_.SetCompliance(extension_on_state_ * from_end_, rate_on_state_ * from_end_ + rate_on_remainder_);
}

void CondensedStepper::MakeSensorRows(const CondensedModel& model, const MatrixXd& state_matrix,
                                      const MatrixXd& by_posts) {
  const Index n = model.mass.rows();
  const Index sensors = model.on_position.rows();
  if (sensors == 0) {
    on_state_.resize(0, state_matrix.rows());
    sensor_on_remainder_.resize(0, on_remainder_.cols());
    on_post_.resize(0, post_.size());
    return;
  }
  on_state_ = model.on_acceleration * state_matrix.middleRows(n, n);
  on_state_.leftCols(n) += model.on_position;
  on_state_.middleCols(n, n) += model.on_velocity;
  on_post_.resize(sensors, post_.size());
  on_post_ << model.on_post_height, model.on_post_velocity, model.on_post_acceleration;
  on_post_.leftCols(by_posts.cols()) += model.on_acceleration * by_posts.middleRows(n, n);
  sensor_on_remainder_ = model.on_acceleration * on_remainder_.middleRows(n, n);
  for (std::size_t j = 0; j < ports_.size(); ++j)
    if (ports_[j].liftoff >= 0)
      for (const int cell : model.liftoffs[static_cast<std::size_t>(ports_[j].liftoff)].load_cells)
        sensor_on_remainder_(cell, static_cast<Index>(j)) += 1;
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

void CondensedStepper::AddPostsToPorts() {
  const Index posts = post_.size() / 3;
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    if (ports_[j].post < 0) continue;
    extension_[static_cast<Index>(j)] += post_[ports_[j].post];
    rate_[static_cast<Index>(j)] += post_[posts + ports_[j].post];
  }
}

void CondensedStepper::Start(std::span<const PostState> posts) {
  RequireCount("CondensedStepper", "posts", post_count(), posts.size());
  SetPosts(posts);
  state_.setZero();
  remainder_.setZero();
  extension_.setZero();
  rate_.setZero();
  unsolved_steps_ = 0;
  at_start_.Rest();
  at_end_.Rest();
  AddPostsToPorts();
  if (!at_start_.Solve(extension_, rate_, remainder_)) ++unsolved_steps_;
}

void CondensedStepper::SetState(const Eigen::VectorXd& state, std::span<const PostState> posts) {
  RequireCount("CondensedStepper", "states", static_cast<std::size_t>(state_.size()),
               static_cast<std::size_t>(state.size()));
  SetPosts(posts);
  state_ = state;
  if (remainder_.size() == 0) return;
  extension_.noalias() = extension_on_state_ * state_;
  rate_.noalias() = rate_on_state_ * state_;
  AddPostsToPorts();
  if (!at_start_.Solve(extension_, rate_, remainder_)) ++unsolved_steps_;
}

void CondensedStepper::Step(std::span<const PostState> posts) {
  const Index n = state_.size();
  const Index ports = remainder_.size();
  const Index half = 2 * (post_.size() / 3);
  packed_.head(n) = state_;
  packed_.segment(n, ports) = remainder_;
  packed_.segment(n + ports, half) = post_.head(half);
  SetPosts(posts);
  packed_.tail(half) = post_.head(half);
  state_.noalias() = from_start_ * packed_;
  if (ports == 0) return;
  extension_.noalias() = extension_on_state_ * state_;
  rate_.noalias() = rate_on_state_ * state_;
  AddPostsToPorts();
  if (!at_end_.Solve(extension_, rate_, remainder_)) ++unsolved_steps_;
  state_.noalias() += from_end_ * remainder_;
}

void CondensedStepper::Read(Eigen::Ref<Eigen::VectorXd> readings) const {
  readings.noalias() = on_state_ * state_;
  readings.noalias() += sensor_on_remainder_ * remainder_;
  readings.noalias() += on_post_ * post_;
}

}  // namespace fourpost
