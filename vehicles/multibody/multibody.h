#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vehicles/description/post_motion.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Forces in the design pose: tension of each spring, vertical force of each tyre (pushing), and the forces of each
/// bushing along its axes [N].
struct Preloads {
  std::vector<double> spring;
  std::vector<double> tyre;
  std::vector<Eigen::Vector3d> bushing;
};

/// A loop closure and its rows in LoopError and LoopJacobian.
struct LoopClosure {
  /// Name in messages: "fp:rod 'panhard'".
  std::string element;
  int source_line = 0;
  int first_row = 0;
  int rows = 0;
};

/// Report of an integration step: time, state [q u z] and the sensors' readings in their file order.
using MarchSink = std::function<void(double t, const Eigen::VectorXd& state, const Eigen::VectorXd& sensors)>;

/// The vehicle as a nonlinear multibody system in Simbody: bodies, joints, loop closures and force elements. Joint
/// coordinates q: revolute angle; prismatic travel; planar angle, x, y; floating body-fixed x-y-z angles, x, y, z;
/// dq/dt = u for all of them. z: extension of the spring of each series damper in file order [m], then the pressures of
/// each hydraulic damper above rest (rebound, bump chamber) [MPa], then the tension of friction that sticks over its
/// sliding force. Not thread-safe: one per thread.
class Multibody {
 public:
  /// Throws FaultyInput, naming the loops and their gaps, if the loop closures cannot be assembled.
  explicit Multibody(const Vehicle& vehicle);
  ~Multibody();
  Multibody(Multibody&&) noexcept;
  Multibody& operator=(Multibody&&) noexcept;

  const Vehicle& vehicle() const;

  /// Number of joint coordinates, not reduced by loop closures.
  int coordinate_count() const;
  int state_size() const;
  /// Joint coordinates that close all loops, nearest to zero.
  const Eigen::VectorXd& design_pose() const;

  /// Changes masses, inertias, rates and laws of the existing system; topology and pose stay.
  /// Throws std::invalid_argument for another number of parameters, springs, tyres or bushings than the vehicle has.
  void SetParameters(std::span<const double> parameters, const Preloads& preloads);
  void SetPostMotion(PostMotion motion);

  // Geometry in the last pose, set by SetPose or by the last state evaluated; initially the design pose.
  /// Throws std::invalid_argument for another number of coordinates, as do the functions below for another of states.
  void SetPose(const Eigen::VectorXd& q);
  Eigen::Isometry3d LinkPose(int link) const;
  /// 6 x coordinates: angular velocity and velocity of the link's origin, in ground axes, per unit u.
  Eigen::MatrixXd LinkJacobian(int link) const;
  /// Extension of each hydraulic damper with its mount, then of each friction that sticks, in file order, from the
  /// design pose [m].
  Eigen::VectorXd MemoryExtensions() const;
  /// Loop closure errors [m, or rad] and their derivatives by q.
  const std::vector<LoopClosure>& loop_closures() const;
  Eigen::VectorXd LoopError() const;
  Eigen::MatrixXd LoopJacobian() const;
  /// Transpose of LoopJacobian times these: forces on q of the loops' forces, in a pass for all of them.
  Eigen::VectorXd LoopForces(const Eigen::VectorXd& of_loops) const;

  /// Moves the vehicle to time t and state [q u z], for the functions below without a state. Throws std::runtime_error
  /// if Simbody cannot evaluate the state.
  void SetState(double t, const Eigen::VectorXd& state);
  /// Second derivatives of LoopError by time where u' = 0.
  Eigen::VectorXd LoopBias() const;

  /// d[q u z]/dt at time t.
  Eigen::VectorXd StateDerivative(double t, const Eigen::VectorXd& state);

  /// Inverse dynamics at time t: the lacking forces (or rates) for the state [q u z] to change at the rate `derivative`
  /// = d[q u z]/dt.
  ///   per coordinate       M(q) u' - forces(t, q, u, z)                     [N, or N m for an angle], n entries,
  ///   per series damper    spring force(z) - dashpot force(v - z')         [N], in file order,
  ///   per hydraulic damper z' - rates of its oil and valves at v           [MPa/s], two each,
  ///   per friction that sticks   z' - rate of its law at v                 [1/s],
  /// v: extension rate of the damper. All zero where derivative = StateDerivative(t, state), which costs more and
  /// divides by the dashpots' rates. Forces of loop closures are left out. Throws std::runtime_error if Simbody cannot
  /// evaluate the state.
  Eigen::VectorXd Residual(double t, const Eigen::VectorXd& state, const Eigen::VectorXd& derivative);
  Eigen::VectorXd Residual(const Eigen::VectorXd& derivative);

  /// Sensor readings at time t, in file order. Throws std::runtime_error if Simbody cannot evaluate the state.
  Eigen::VectorXd Readings(double t, const Eigen::VectorXd& state);
  /// Sensor readings if the state changed at the rate `derivative` = d[q u z]/dt.
  Eigen::VectorXd Readings(const Eigen::VectorXd& derivative);

  /// State at rest in the design pose.
  Eigen::VectorXd RestState() const;

  /// Integrates from `state` at `start`, reporting at start + k step for k = 0 .. until `sink_done` returns true. Error
  /// control of Simbody's Runge-Kutta-Merson integrator at this relative accuracy. Throws std::runtime_error if the
  /// integration fails.
  void Integrate(const Eigen::VectorXd& state, double start, double step, double accuracy, const MarchSink& sink,
                 const std::function<bool()>& done);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fourpost
