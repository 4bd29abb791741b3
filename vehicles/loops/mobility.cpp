#include "vehicles/loops/mobility.h"

#include <random>

#include "vehicles/loops/chart.h"
#include "vehicles/loops/loop_lock.h"
#include "vehicles/loops/loop_space.h"

namespace fourpost {
namespace {

/// Steps of the independent coordinates [m, rad].
std::vector<Eigen::VectorXd> Excursions(int dof) {
  // Some hundred thousand times what a closed pose is in error; lower by far than what a suspension travels.
  constexpr double kStep = 5e-3;
  constexpr int kCombinations = 8;
  std::vector<Eigen::VectorXd> steps;
  for (int i = 0; i < dof; ++i)
    for (const double side : {-kStep, kStep}) steps.emplace_back(side * Eigen::VectorXd::Unit(dof, i));
  std::mt19937 draws(1);
  for (int k = 0; k < kCombinations && dof > 0; ++k) {
    Eigen::VectorXd step(dof);
    for (double& entry : step) entry = static_cast<double>(draws()) / std::mt19937::max() - 0.5;
    steps.emplace_back(kStep * step.normalized());
  }
  return steps;
}

void RequireThatItMoves(Multibody& multibody) {
  if (const Diagnostics locks = LoopLocks(multibody); locks.HasErrors()) throw FaultyInput(locks);
  Chart chart(multibody);
  for (const Eigen::VectorXd& step : Excursions(chart.size())) chart.MoveTo(step);
}

/// How many of a closure's equations follow from those of the others.
int Repeated(const Eigen::MatrixXd& jacobian, const LoopClosure& closure, Eigen::Index rank) {
  const Eigen::Index after = closure.first_row + closure.rows;
  Eigen::MatrixXd others(jacobian.rows() - closure.rows, jacobian.cols());
  others << jacobian.topRows(closure.first_row), jacobian.bottomRows(jacobian.rows() - after);
  return closure.rows - static_cast<int>(rank - LoopSpaceOf(others).rank);
}

}  // namespace

Mobility MobilityOf(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  Mobility mobility{.joint_coordinates = multibody.coordinate_count(), .dof = multibody.coordinate_count()};
  if (!vehicle.HasLoops()) return mobility;
  multibody.SetPose(multibody.design_pose());
  const Eigen::MatrixXd jacobian = multibody.LoopJacobian();
  const Eigen::Index rank = LoopSpaceOf(jacobian).rank;
  mobility.loop_equations = static_cast<int>(jacobian.rows());
  mobility.independent_equations = static_cast<int>(rank);
  mobility.dof -= mobility.independent_equations;
  mobility.loop_residual = multibody.LoopError().lpNorm<Eigen::Infinity>();
  RequireThatItMoves(multibody);
  for (const LoopClosure& closure : multibody.loop_closures())
    if (const int repeated = Repeated(jacobian, closure, rank); repeated > 0)
      mobility.redundant.push_back(closure.element + " (" + std::to_string(repeated) + " of " +
                                   std::to_string(closure.rows) + ")");
  return mobility;
}

}  // namespace fourpost
