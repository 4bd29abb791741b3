#include "identify/problems/pressure_vessel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fourpost {
namespace {

constexpr double kSheet_in = 0.0625;
constexpr double kVolume_in3 = 1296000;

Evaluation Cost(const Eigen::VectorXd& design) {
  const double shell = kSheet_in * design[0];
  const double head = kSheet_in * design[1];
  const double radius = design[2];
  const double length = design[3];
  const double volume = std::numbers::pi * radius * radius * (length + 4 * radius / 3);
  // Shares by which thicknesses and volume are too small.
  const double violation = std::max(0.0, 0.0193 * radius - shell) / shell +
                           std::max(0.0, 0.00954 * radius - head) / head +
                           std::max(0.0, kVolume_in3 - volume) / kVolume_in3;
  if (violation > 0) return Infeasible(violation, "a constraint is violated");
  Evaluation evaluation;
  const double cost = 0.6224 * shell * radius * length + 1.7781 * head * radius * radius +
                      3.1661 * shell * shell * length + 19.84 * shell * shell * radius;
  evaluation.residuals = Eigen::VectorXd::Constant(1, std::sqrt(cost));
  return evaluation;
}

}  // namespace

Problem PressureVesselProblem() {
  return {Lattice({{.name = "shell", .lower = 1, .upper = 99, .precision = 1, .discrete = true},
                   {.name = "head", .lower = 1, .upper = 99, .precision = 1, .discrete = true},
                   {.name = "radius", .lower = 10, .upper = 200, .precision = 1e-6},
                   {.name = "length", .lower = 10, .upper = 200, .precision = 1e-6}}),
          Cost, 1};
}

}  // namespace fourpost
