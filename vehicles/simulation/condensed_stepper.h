#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/port.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/port_solver.h"

namespace fourpost {

/// Time integration of a reduced vehicle by steps of one length h. With X = [s s' x], the posts' motion z and the
/// nonlinear forces r of the elements (LinearVehicle, centre rates)
///   X' = A X + B z + C z' + P r,  r_j = R_j(e_j, e'_j)
/// is solved over a step by exp(h A): exactly for z the cubic through heights and velocities at both ends, and for r
/// linear in time between the ends, where all laws hold. Linear vehicles err by h^4 of the posts' motion within a step,
/// others by h^2. Dashpots of any rate are stable at any step length, because centre rates keep their nonlinear parts
/// within the damping of their linear parts. A stop that adds the rate k to a mass m needs h < 3.4 sqrt(m / k), as in
/// Newmark's method of linear acceleration. The oil of hydraulic dampers is integrated by HydraulicStep, friction that
/// sticks by FrictionStep. Tyres that may lift off are taken as linear in a step; if one would pull at its end, the
/// step is repeated with their ports. Matrices are computed once, those of lift-off when a tyre first lifts; a step
/// allocates nothing. With added forces g on [s x], linear in time over a step like r,
///   X' = A X + B z + C z' + P r + G g,
/// and the ports of all tyres are included in each step.
class CondensedStepper {
 public:
  /// Whether Step() takes added forces.
  enum class Forces { kNone, kAdded };

  /// Throws std::invalid_argument unless the step is positive and finite.
  CondensedStepper(const CondensedModel& model, double step_s, Forces forces = Forces::kNone);

  double step_s() const { return step_s_; }
  /// Posts, and behind them actuators: see PostMotion.
  std::size_t post_count() const { return static_cast<std::size_t>(post_.size()) / 3; }
  Eigen::Index sensor_count() const { return on_state_.rows(); }

  /// The vehicle at rest in its design pose, the posts as given.
  void Start(std::span<const PostState> posts);

  /// Sets another state, for example corrected by a filter, the posts as given. Friction that sticks has come there
  /// from the design pose in one stroke, or by the strokes [m] that stand behind the state, one each. Not for vehicles
  /// with hydraulic dampers, whose oil has a memory of its own.
  void SetState(const Eigen::VectorXd& state, std::span<const PostState> posts);

  /// One step, to these posts. For Forces::kNone.
  void Step(std::span<const PostState> posts);
  /// With these added forces at its end; they are zero at the start. For Forces::kAdded.
  void Step(std::span<const PostState> posts, const Eigen::VectorXd& added);

  /// An end of a step, to which Return() can go back.
  struct Moment {
    Eigen::VectorXd state;
    Eigen::VectorXd remainder;
    Eigen::VectorXd trend;
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

  /// Whether a tyre is off its platform. For Forces::kNone.
  bool lifts() const { return acting_ > held_; }

  /// Sensor readings.
  void Read(Eigen::Ref<Eigen::VectorXd> readings) const;

  /// Number of steps since Start() whose nonlinear forces did not converge.
  long unsolved_steps() const { return unsolved_steps_; }

 private:
  /// Differentiates the step as it is.
  friend class MotionSensitivity;

  /// `ports`: of the model's, those whose forces are solved for; tyres that may lift off last.
  CondensedStepper(const CondensedModel& model, double step_s, Forces forces, std::vector<Port> ports);

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
  void RestFrictions(const Eigen::VectorXd& strokes);
  void FinishStart();
  void FinishStep();

  double step_s_;
  std::vector<Port> ports_;
  /// Ports included in each step: all except tyres that may lift off, which come last; with added forces all. And the
  /// number of ports with a nonlinear force, from the first on: these, or all while a tyre is off its platform.
  Eigen::Index held_ = 0;
  Eigen::Index acting_ = 0;
  /// A: N x N, and [B C]: N x 2 posts.
  Eigen::MatrixXd state_matrix_;
  Eigen::MatrixXd by_posts_;
  /// N x [s x]: rate of the state per added force; then the effect of those at a step's start and end on the state at
  /// its end. Without columns: none are added.
  Eigen::MatrixXd on_added_;
  Eigen::MatrixXd added_from_start_;
  Eigen::MatrixXd added_from_end_;
  /// N x ports: rate of the state per nonlinear force.
  Eigen::MatrixXd on_remainder_;
  /// N x (N + held ports + 4 posts): maps [X r, then z z' at the start and at the end] to the state at the end, except
  /// ...
  Eigen::MatrixXd from_start_;
  /// ... N x ports, or held ports until a tyre lifts: for the nonlinear forces at the end.
  Eigen::MatrixXd from_end_;
  /// N x lift-offs, once a tyre lifts: the same for their nonlinear forces at the start.
  Eigen::MatrixXd from_liftoff_;
  /// ports x N and ports x ports: extension and rate at an instant.
  Eigen::MatrixXd extension_on_state_;
  Eigen::MatrixXd rate_on_state_;
  Eigen::MatrixXd rate_on_remainder_;
  Eigen::MatrixXd rate_on_added_;
  /// N x tyres that may lift off, 2 posts x tyres: vertical force of each [N] by state, heights and velocities; and at
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
  /// Of the held ports, at the step's start, and their change in the last one, on from which they are looked for.
  Eigen::VectorXd remainder_before_;
  Eigen::VectorXd trend_;
  Eigen::VectorXd added_;
  /// Heights, velocities, accelerations of the posts.
  Eigen::VectorXd post_;
  Eigen::VectorXd packed_;
  /// State at the end of a step without the nonlinear forces there.
  Eigen::VectorXd free_;
  Eigen::VectorXd extension_;
  Eigen::VectorXd rate_;
  long unsolved_steps_ = 0;
};

}  // namespace fourpost
