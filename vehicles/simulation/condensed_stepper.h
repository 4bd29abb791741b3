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
/// along by HydraulicStep. Tyres that may lift off are taken for linear in a step; where one would pull at its end, the
/// step is taken again with their ports. Matrices are made once, those of lift-off when a tyre first does; a step
/// allocates nothing.
/// With forces g added on [s x], which go straight from one end of a step to the other as remainders do,
///   X' = A X + B z + C z' + P r + G g,
/// and the ports of all tyres are taken in each step.
class CondensedStepper {
 public:
  /// Whether Step() takes added forces.
  enum class Forces { kNone, kAdded };

  /// Throws std::invalid_argument unless the step is positive and finite.
  CondensedStepper(const CondensedModel& model, double step_s, Forces forces = Forces::kNone);

  double step_s() const { return step_s_; }
  std::size_t post_count() const { return static_cast<std::size_t>(post_.size()) / 3; }
  Eigen::Index sensor_count() const { return on_state_.rows(); }

  /// The vehicle at rest in its design pose, the posts as given.
  void Start(std::span<const PostState> posts);

  /// Another state, as a filter corrects it, the posts as given. Of vehicles without hydraulic dampers, whose oil has a
  /// memory of its own.
  void SetState(const Eigen::VectorXd& state, std::span<const PostState> posts);

  /// One step, to these posts. Of Forces::kNone.
  void Step(std::span<const PostState> posts);
  /// And to these added forces, which are zero at the start. Of Forces::kAdded.
  void Step(std::span<const PostState> posts, const Eigen::VectorXd& added);

  /// An end of a step, to which Return() goes back.
  struct Moment {
    Eigen::VectorXd state;
    Eigen::VectorXd remainder;
    Eigen::VectorXd post;
    Eigen::VectorXd added;
    PortSolver::Memory memory;
    Eigen::Index acting = 0;
    long unsolved_steps = 0;
  };
  void Store(Moment& moment) const;
  void Return(const Moment& moment);

  /// [s s' x].
  const Eigen::VectorXd& state() const { return state_; }

  /// [s' s'' x'].
  Eigen::VectorXd StateRate() const;

  /// Whether a tyre is off its platform. Of Forces::kNone.
  bool lifts() const { return acting_ > held_; }

  /// What the sensors read.
  void Read(Eigen::Ref<Eigen::VectorXd> readings) const;

  /// Steps since Start() whose remainders did not converge.
  long unsolved_steps() const { return unsolved_steps_; }

 private:
  void MakeStepMatrices();
  void MakeForceMatrices();
  void MakePortRows(const CondensedModel& model);
  void MakeTyreRows(const CondensedModel& model);
  void MakeSensorRows(const CondensedModel& model);
  void MakeLiftoffColumns();
  void SetPosts(std::span<const PostState> posts);
  bool SolvePorts(PortSolver& solver, Eigen::Index count);
  bool AnyTyrePulls() const;
  void AdvanceState(std::span<const PostState> posts);
  void FinishStart();
  void FinishStep();

  double step_s_;
  std::vector<Port> ports_;
  /// Ports that are taken in each step: but those of tyres that may lift off, which come last, or with added forces
  /// all. And how many, from the first on, have a remainder: these, or all while a tyre is off its platform.
  Eigen::Index held_ = 0;
  Eigen::Index acting_ = 0;
  /// A: N x N, and [B C]: N x 2 posts.
  Eigen::MatrixXd state_matrix_;
  Eigen::MatrixXd by_posts_;
  /// N x [s x]: rate of the state by added forces; then what those at a step's start and end make of the state at its
  /// end. Without columns: none are taken.
  Eigen::MatrixXd on_added_;
  Eigen::MatrixXd added_from_start_;
  Eigen::MatrixXd added_from_end_;
  /// N x ports: rate of the state by remainders.
  Eigen::MatrixXd on_remainder_;
  /// N x (N + held ports + 4 posts): of [X r, then z z' at the start and at the end], the state at the end but for ...
  Eigen::MatrixXd from_start_;
  /// ... N x ports, or held ports until a tyre lifts: the remainders at the end.
  Eigen::MatrixXd from_end_;
  /// N x lift-offs, once a tyre lifts: the same of their remainders at the start.
  Eigen::MatrixXd from_liftoff_;
  /// ports x N and ports x ports: extension and rate at an instant.
  Eigen::MatrixXd extension_on_state_;
  Eigen::MatrixXd rate_on_state_;
  Eigen::MatrixXd rate_on_remainder_;
  Eigen::MatrixXd rate_on_added_;
  /// N x tyres that may lift off, 2 posts x tyres: compression of each [N] by state, heights and velocities; and at
  /// rest.
  Eigen::MatrixXd compression_by_state_;
  Eigen::MatrixXd compression_by_post_;
  Eigen::VectorXd preload_;
  /// sensors x N, sensors x ports, sensors x 3 posts (heights, velocities, accelerations).
  Eigen::MatrixXd on_state_;
  Eigen::MatrixXd sensor_on_remainder_;
  Eigen::MatrixXd on_post_;
  PortSolver at_start_;
  PortSolver at_end_;

  Eigen::VectorXd state_;
  Eigen::VectorXd remainder_;
  Eigen::VectorXd added_;
  /// Heights, velocities, accelerations of the posts.
  Eigen::VectorXd post_;
  Eigen::VectorXd packed_;
  /// At the end of a step without the remainders there.
  Eigen::VectorXd free_;
  Eigen::VectorXd extension_;
  Eigen::VectorXd rate_;
  long unsolved_steps_ = 0;
};

}  // namespace fourpost
