#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/port.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/port_solver.h"

namespace fourpost {

/// A condensed vehicle in time by steps of one length h. With X = [s s' x], the posts' motion z and the remainders r of
/// the ports (LinearVehicle, centre rates)
///   X' = A X + B z + C z' + P r,  r_j = R_j(e_j, e'_j)
/// is solved for a step as exp(h A) has it, exactly for z the cubic through heights and velocities at its two ends, and
/// for r that goes straight from its value at the start to that at the end, where all laws hold. Linear vehicles err by
/// h^4 for what the posts do between, others by h^2. Dashpots of any rate leave the step stable at any length, for
/// centre rates keep their remainders within what their linear shares damp. A stop that adds the rate k to a mass m
/// wants h < 3.4 sqrt(m / k), as Newmark's method of linear acceleration does. The oil of hydraulic dampers goes
/// along by HydraulicStep. Matrices are made once; a step allocates nothing.
class CondensedStepper {
 public:
  /// Throws std::invalid_argument unless the step is positive and finite.
  CondensedStepper(const CondensedModel& model, double step_s);

  double step_s() const { return step_s_; }
  std::size_t post_count() const { return static_cast<std::size_t>(post_.size()) / 3; }
  Eigen::Index sensor_count() const { return on_state_.rows(); }

  /// The vehicle at rest in its design pose, the posts as given.
  void Start(std::span<const PostState> posts);

  /// Another state, as a filter corrects it, the posts as given. Of vehicles without hydraulic dampers, whose oil has a
  /// memory of its own.
  void SetState(const Eigen::VectorXd& state, std::span<const PostState> posts);

  /// One step, to these posts.
  void Step(std::span<const PostState> posts);

  /// [s s' x].
  const Eigen::VectorXd& state() const { return state_; }

  /// What the sensors read.
  void Read(Eigen::Ref<Eigen::VectorXd> readings) const;

  /// Steps since Start() whose remainders did not converge.
  long unsolved_steps() const { return unsolved_steps_; }

 private:
  void MakeStepMatrices(const Eigen::MatrixXd& state_matrix, const Eigen::MatrixXd& posts);
  void MakePortRows(const CondensedModel& model, const Eigen::MatrixXd& state_matrix);
  void MakeSensorRows(const CondensedModel& model, const Eigen::MatrixXd& state_matrix, const Eigen::MatrixXd& posts);
  void SetPosts(std::span<const PostState> posts);
  void AddPostsToPorts();

  double step_s_;
  std::vector<Port> ports_;
  /// N x ports: rate of the state by remainders.
  Eigen::MatrixXd on_remainder_;
  /// N x (N + ports + 4 posts): of [X r, then z z' at the start and at the end], the state at the end but for ...
  Eigen::MatrixXd from_start_;
  /// ... N x ports: the remainders at the end.
  Eigen::MatrixXd from_end_;
  /// ports x N and ports x ports: extension and rate at an instant.
  Eigen::MatrixXd extension_on_state_;
  Eigen::MatrixXd rate_on_state_;
  Eigen::MatrixXd rate_on_remainder_;
  /// sensors x N, sensors x ports, sensors x 3 posts (heights, velocities, accelerations).
  Eigen::MatrixXd on_state_;
  Eigen::MatrixXd sensor_on_remainder_;
  Eigen::MatrixXd on_post_;
  PortSolver at_start_;
  PortSolver at_end_;

  Eigen::VectorXd state_;
  Eigen::VectorXd remainder_;
  /// Heights, velocities, accelerations of the posts.
  Eigen::VectorXd post_;
  Eigen::VectorXd packed_;
  Eigen::VectorXd extension_;
  Eigen::VectorXd rate_;
  long unsolved_steps_ = 0;
};

}  // namespace fourpost
