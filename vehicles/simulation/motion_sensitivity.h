#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/simulation/condensed_stepper.h"

namespace fourpost {

/// How the motion of a CondensedStepper differs, to first order, from that of neighbours: the same vehicle with one
/// parameter each a little different, or with other elements. What follows from state and forces is differentiated as
/// the step computes it; the matrices of steps and the laws themselves by their differences. So it costs a product of
/// matrices per step where integrating each neighbour would solve for its forces anew (forward sensitivities). An
/// element that only a neighbour has acts with the force that the model's own motion gives it.
class MotionSensitivity {
 public:
  /// Whether a neighbour has the same coordinates, posts and sensors, neither has hydraulic dampers, and the neighbour
  /// no friction that sticks which the model has not.
  static bool Covers(const CondensedModel& model, const CondensedModel& neighbour);

  /// Of steppers with this step. Throws as CondensedStepper does. `neighbours`: covered, see Covers().
  MotionSensitivity(const CondensedModel& model, std::span<const CondensedModel> neighbours, double step_s);

  /// After CondensedStepper::Start() of the model.
  void Start(const CondensedStepper& base);
  /// After each Step() of it.
  void Step(const CondensedStepper& base);

  /// Sensor readings of the neighbours less those of the model, sensors x neighbours.
  void Read(const CondensedStepper& base, Eigen::Ref<Eigen::MatrixXd> changes);

 private:
  /// Of a port whose law a neighbour has not in common with the model; empty: it is linear there, and no port.
  struct Law {
    Eigen::Index port = 0;
    Eigen::Index neighbour = 0;
    std::optional<PortLaw> law;
  };
  /// Of an element that only a neighbour has.
  struct AddedPort {
    Eigen::Index neighbour = 0;
    Port port;
  };

  Eigen::Index count() const { return static_cast<Eigen::Index>(neighbours_.size()); }
  /// One neighbour's differences below the other; empty where there are none.
  Eigen::MatrixXd Stacked(const CondensedStepper& base, Eigen::MatrixXd CondensedStepper::*part) const;
  /// Adds what the differences of the first columns make of a vector, column by column of `sum`.
  void Add(const Eigen::MatrixXd& stack, const Eigen::Ref<const Eigen::VectorXd>& vector,
           Eigen::Ref<Eigen::MatrixXd> sum);
  void MakeLiftoffColumns(const CondensedStepper& base);
  void MakeAddedPorts(const CondensedStepper& base, const CondensedModel& model);
  void FindAddedForces(const CondensedStepper& base);
  /// Adds what the added elements' forces make of themselves through these columns.
  void AddForces(const Eigen::Ref<const Eigen::MatrixXd>& columns, const Eigen::VectorXd& forces,
                 Eigen::Ref<Eigen::MatrixXd> sum) const;
  /// Of the first `count` ports, at a state changed by `state`, but for the changes of their own forces.
  void SolvePorts(const CondensedStepper& base, const PortSolver& solver, Eigen::Index count,
                  const Eigen::MatrixXd& state);
  void NoteFrictions(const CondensedStepper& base);

  std::vector<CondensedStepper> neighbours_;
  std::vector<Law> laws_;
  /// Those of all neighbours; a column, or a row, for each: what its force at a step's start and end does to the state,
  /// to the rates of the model's ports and to the sensors, and what its own extension and rate follow from.
  std::vector<AddedPort> added_;
  Eigen::MatrixXd added_from_start_;
  Eigen::MatrixXd added_from_end_;
  Eigen::MatrixXd rate_on_added_;
  Eigen::MatrixXd sensor_on_added_;
  Eigen::MatrixXd added_extension_on_state_;
  Eigen::MatrixXd added_rate_on_state_;
  Eigen::MatrixXd added_rate_on_remainder_;
  Eigen::VectorXd added_forces_;
  Eigen::VectorXd added_before_;

  Eigen::MatrixXd from_start_;
  Eigen::MatrixXd from_end_;
  Eigen::MatrixXd from_liftoff_;
  Eigen::MatrixXd extension_on_state_;
  Eigen::MatrixXd rate_on_state_;
  Eigen::MatrixXd rate_on_remainder_;
  Eigen::MatrixXd on_state_;
  Eigen::MatrixXd sensor_on_remainder_;
  Eigen::MatrixXd on_post_;

  /// Changes, a column per neighbour: of the state, and of all ports' nonlinear forces.
  Eigen::MatrixXd state_;
  Eigen::MatrixXd remainder_;
  /// The model's own at the start of the next step.
  Eigen::VectorXd remainder_before_;
  bool lifted_before_ = false;

  /// Ports with friction that sticks; of these the changes at the start of the step.
  std::vector<Eigen::Index> frictions_;
  Eigen::MatrixXd friction_extension_;
  Eigen::MatrixXd friction_force_;

  Eigen::MatrixXd free_;
  Eigen::MatrixXd extension_;
  Eigen::MatrixXd rate_;
  Eigen::VectorXd product_;
};

}  // namespace fourpost
